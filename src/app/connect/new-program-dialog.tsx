import { useSignal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { type NewProgram, newProgram, USUAL_LAYOUT } from '../editing/new-program.js';
import { messages } from '../messages/index.js';
import { FormButtons } from '../ui/form-buttons.js';
import { LayoutChoice } from '../ui/layout-choice.js';
import { Modal } from '../ui/modal.js';
import './new-program-dialog.css';

interface NewProgramDialogProps {
  readonly open: boolean;
  readonly onMake: (program: TimerProgram) => void;
  readonly onClose: () => void;
}

const FIRST: NewProgram = { timerClass: 'Q', ...USUAL_LAYOUT, from: 'usual' };

/** Asks for class, layout and first values of a program that is made without a timer. */
export function NewProgramDialog({ open, onMake, onClose }: NewProgramDialogProps) {
  const { newProgram: words } = messages.value;
  return (
    <Modal open={open} title={words.title} onEscape={onClose}>
      <Choices onMake={onMake} onClose={onClose} />
    </Modal>
  );
}

function Choices({ onMake, onClose }: Omit<NewProgramDialogProps, 'open'>) {
  const { newProgram: words } = messages.value;
  const wanted = useSignal(FIRST);
  const choose = (part: Partial<NewProgram>): void => {
    wanted.value = { ...wanted.value, ...part };
  };
  return (
    <form
      class="stack gap-4 new-program"
      onSubmit={(event) => {
        event.preventDefault();
        onClose();
        onMake(newProgram(wanted.value));
      }}
    >
      <p>{words.lead}</p>
      <LayoutChoice wanted={wanted.value} onChoose={choose} />
      <fieldset>
        <legend>{words.from}</legend>
        {(['usual', 'nothing'] as const).map((each) => (
          <label class="check" key={each}>
            <input
              type="radio"
              name="new-from"
              checked={each === wanted.value.from}
              onChange={() => choose({ from: each })}
            />
            {words.beginnings[each]}
          </label>
        ))}
      </fieldset>
      <p class="hint">{words.caution}</p>
      <FormButtons label={words.make} onCancel={onClose} />
    </form>
  );
}
