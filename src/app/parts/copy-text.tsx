import { useSignal } from '@preact/signals';
import { useId, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';

/** A line to be typed elsewhere, with a button that copies it. A click on the line marks all of it, for where there is no clipboard. */
export function CopyText({ text }: { text: string }) {
  const { copy, copied, marked } = messages.value.help;
  const done = useSignal<string | null>(null);
  const line = useRef<HTMLElement>(null);
  const id = useId();
  const mark = (): void => {
    if (line.current) getSelection()?.selectAllChildren(line.current);
  };
  const put = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(text);
      done.value = copied;
    } catch {
      mark();
      done.value = marked;
    }
  };
  return (
    <div class="copy-text">
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the button beside it does the same by keyboard */}
      <code id={id} ref={line} onClick={mark}>
        {text}
      </code>
      <button type="button" aria-describedby={id} onClick={() => void put()} onBlur={() => (done.value = null)}>
        {done.value ?? copy}
      </button>
      <span class="visually-hidden" role="status">
        {done.value}
      </span>
    </div>
  );
}
