import { useSignal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { CLASSES, LAYOUTS, type NewProgram, newProgram, USUAL_LAYOUT } from '../editing/new-program.js';
import { messages } from '../messages/index.js';
import { CountChoice } from '../ui/count-choice.js';
import { FormButtons } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import { SegmentChoice } from '../ui/segment-choice.js';
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
  const { newProgram: words, classNames } = messages.value;
  const wanted = useSignal(FIRST);
  const choose = (part: Partial<NewProgram>): void => {
    wanted.value = { ...wanted.value, ...part };
  };
  const { timerClass, functions, servos, from } = wanted.value;
  return (
    <form
      class="new-program"
      onSubmit={(event) => {
        event.preventDefault();
        onClose();
        onMake(newProgram(wanted.value));
      }}
    >
      <p>{words.lead}</p>
      <SegmentChoice
        name="new-class"
        title={words.timerClass}
        choices={CLASSES}
        names={classNames as Record<(typeof CLASSES)[number], string>}
        chosen={timerClass}
        onChoose={(choice) => choose({ timerClass: choice })}
      />
      <div class="new-layout">
        <CountChoice
          label={words.functions}
          range={LAYOUTS.functions}
          value={functions}
          // The wire counts DT as a function; a pilot does not.
          shown={(count) => count - 1}
          onChoose={(count) => choose({ functions: count })}
        />
        <CountChoice
          label={words.servos}
          range={LAYOUTS.servos}
          value={servos}
          onChoose={(count) => choose({ servos: count })}
        />
      </div>
      <fieldset>
        <legend>{words.from}</legend>
        {(['usual', 'nothing'] as const).map((each) => (
          <label class="check" key={each}>
            <input type="radio" name="new-from" checked={each === from} onChange={() => choose({ from: each })} />
            {words.beginnings[each]}
          </label>
        ))}
      </fieldset>
      <p class="hint">{words.caution}</p>
      <FormButtons label={words.make} onCancel={onClose} />
    </form>
  );
}
