import { useId, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { useCopy } from './use-copy.js';
import './copy-text.css';

/**
 * A line to type elsewhere, with a button that copies it.
 * A click on the line selects it, for when there is no clipboard.
 */
export function CopyText({ text }: { text: string }) {
  const words = messages.value.help;
  const line = useRef<HTMLElement>(null);
  const id = useId();
  const mark = (): void => {
    if (line.current) getSelection()?.selectAllChildren(line.current);
  };
  const { copied, refused, copy, forget } = useCopy(() => text, mark);
  const done = copied.value ? words.copied : refused.value === null ? null : words.marked;
  return (
    <div class="copy-text">
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the button beside it does the same by keyboard */}
      <code id={id} ref={line} onClick={mark}>
        {text}
      </code>
      <button type="button" aria-describedby={id} onClick={() => void copy()} onBlur={forget}>
        {done ?? words.copy}
      </button>
      <span class="visually-hidden" role="status">
        {done}
      </span>
    </div>
  );
}
