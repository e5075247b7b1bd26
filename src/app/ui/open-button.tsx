import { useSignal } from '@preact/signals';
import { moreMessages } from '../messages/more.js';

interface OpenButtonProps {
  readonly label: string;
  /** Why it cannot be opened now; null when it can. */
  readonly obstacle: keyof typeof moreMessages.value.obstacles | null;
  readonly primary?: boolean;
  /** Brings a program to the screen. @returns whether it is there. */
  readonly open: () => Promise<boolean>;
  /** Shows the program that was opened. */
  readonly onProgram: () => void;
}

/** Opens a kept program, or says why it cannot be opened. Stands in a row of buttons. */
export function OpenButton({ label, obstacle, primary = false, open, onProgram }: OpenButtonProps) {
  const failed = useSignal(false);
  const show = async (): Promise<void> => {
    failed.value = !(await open());
    if (!failed.peek()) onProgram();
  };
  return (
    <>
      <button
        type="button"
        class={primary ? 'primary' : 'quiet'}
        disabled={obstacle !== null}
        onClick={() => void show()}
      >
        {label}
      </button>
      {obstacle !== null && <p class="hint whole-line">{moreMessages.value.obstacles[obstacle]}</p>}
      {obstacle === null && failed.value && (
        <p class="bad-text whole-line" role="alert">
          {moreMessages.value.library.setting.notShown}
        </p>
      )}
    </>
  );
}
