import type { Said } from '../messages/index.js';

/** What happened, and what to do. */
export function NoticeText({ said: { title, advice } }: { said: Said }) {
  return (
    <p>
      <strong>{title}</strong> {advice}
    </p>
  );
}
