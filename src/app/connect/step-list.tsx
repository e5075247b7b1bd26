import type { ComponentChildren } from 'preact';
import './step-list.css';

export interface StepRow {
  readonly key: string;
  readonly text: string;
  /** It has been taken. */
  readonly done?: boolean;
  /** It is the one to take now. */
  readonly now?: boolean;
  /** What belongs to it. */
  readonly action?: ComponentChildren;
}

/** Steps to take, one after the other, with a tick at those that are behind. */
export function StepList({ steps }: { readonly steps: readonly StepRow[] }) {
  return (
    <ol class="step-list">
      {steps.map(({ key, text, done = false, now = false, action }) => (
        <li key={key} class={done ? 'done' : ''} aria-current={now ? 'step' : undefined}>
          {done && <Tick />}
          <span>{text}</span>
          {action}
        </li>
      ))}
    </ol>
  );
}

/** A tick, for who sees it. */
export function Tick() {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="18" height="18" aria-hidden="true">
      <path d="M5 12.5l4.5 4.5L19 7.5" />
    </svg>
  );
}
