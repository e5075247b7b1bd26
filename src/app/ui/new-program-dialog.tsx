import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import type { TimerProgram } from '../../program/index.js';
import { CLASSES, LAYOUTS, type NewProgram, newProgram, USUAL_LAYOUT } from '../editing/new-program.js';
import { messages } from '../messages/index.js';
import { Choice } from './choice.js';
import { FormButtons } from './form-buttons.js';
import { Modal } from './modal.js';
import { SegmentChoice } from './segment-choice.js';
import './new-program-dialog.css';

interface NewProgramDialogProps {
  readonly open: boolean;
  /** Class and layout to begin with. Default: those of most timers. */
  readonly like?: Partial<NewProgram>;
  /** What else its maker asks for. */
  readonly children?: ComponentChildren;
  readonly onMake: (program: TimerProgram) => void;
  readonly onClose: () => void;
}

const FIRST: NewProgram = { timerClass: 'Q', ...USUAL_LAYOUT, from: 'usual' };

/** Asks for class, layout and first values of a program that is made without a timer. */
export function NewProgramDialog({ open, ...props }: NewProgramDialogProps) {
  return (
    <Modal open={open} title={messages.value.newProgram.title} onEscape={props.onClose}>
      <Form {...props} />
    </Modal>
  );
}

function Form({ like, children, onMake, onClose }: Omit<NewProgramDialogProps, 'open'>) {
  const { newProgram: words, classNames } = messages.value;
  const wanted = useSignal<NewProgram>({ ...FIRST, ...like });
  const choose = (part: Partial<NewProgram>): void => {
    wanted.value = { ...wanted.value, ...part };
  };
  const { timerClass, functions, servos, from } = wanted.value;
  return (
    <form
      class="stack gap-4 new-program"
      onSubmit={(event) => {
        event.preventDefault();
        onClose();
        onMake(newProgram(wanted.value));
      }}
    >
      {children}
      <SegmentChoice
        name="new-class"
        title={words.timerClass}
        choices={CLASSES}
        names={classNames as Record<(typeof CLASSES)[number], string>}
        chosen={timerClass}
        onChoose={(timerClass) => choose({ timerClass })}
      />
      <Choice
        label={words.functions}
        choices={countsIn(LAYOUTS.functions)}
        // The wire counts DT as a function; a pilot does not.
        nameOf={(count) => String(count - 1)}
        chosen={functions}
        onChoose={(functions) => choose({ functions })}
      />
      <Choice
        label={words.servos}
        choices={countsIn(LAYOUTS.servos)}
        nameOf={String}
        chosen={servos}
        onChoose={(servos) => choose({ servos })}
      />
      <SegmentChoice
        name="new-from"
        title={words.from}
        choices={['usual', 'nothing'] as const}
        names={words.beginnings}
        chosen={from}
        onChoose={(from) => choose({ from })}
      />
      <p class="hint">{words.caution}</p>
      <FormButtons label={words.make} onCancel={onClose} />
    </form>
  );
}

function countsIn([first, last]: readonly [first: number, last: number]): number[] {
  return Array.from({ length: last - first + 1 }, (_, at) => first + at);
}
