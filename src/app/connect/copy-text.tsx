import { useId, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { useCopy } from '../ui/use-copy.js';
import './copy-text.css';

/**
 * A line to type elsewhere, with a button that copies it.
 * A click on the line selects it, for when there is no clipboard.
 */
export function CopyText({ text }: { text: string }) {
  const { copy: label, copied: done, line: words } = messages.value;
  const line = useRef<HTMLElement>(null);
  const id = useId();
  const mark = (): void => {
    if (line.current) getSelection()?.selectAllChildren(line.current);
  };
  const { copied, refused, copy, forget } = useCopy(() => text, mark);
  return (
    <div class="copy-text">
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the button beside it does the same by keyboard */}
      <code id={id} ref={line} onClick={mark}>
        {text}
      </code>
      <button type="button" aria-describedby={id} onClick={() => void copy()} onBlur={forget}>
        {label}
      </button>
      <span role="status">{copied.value ? done : refused.value !== null && words.copyByHand}</span>
    </div>
  );
}
