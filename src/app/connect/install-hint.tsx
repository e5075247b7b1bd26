import { useEffect } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { NoticeText } from '../ui/notice-text.js';
import type { Installation } from './installation.js';

/** Tells the pilot that the page can be installed, and how: once, and not while a timer is connected. */
export function InstallHint({ installation }: { readonly installation: Installation }) {
  const { installHint: words, start } = messages.value;
  const hint = installation.hint.value;
  const install = installation.install.value;
  useEffect(() => {
    if (hint !== null) installation.told();
  }, [hint, installation]);
  if (hint === null) return null;
  return (
    <div class="notice">
      <NoticeText said={{ title: words.title, advice: words.ways[hint] }} />
      {install && (
        <button type="button" onClick={install}>
          {start.install}
        </button>
      )}
      <button type="button" class="quiet" onClick={() => installation.endHint()}>
        {words.notNow}
      </button>
    </div>
  );
}
