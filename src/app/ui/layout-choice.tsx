import { CLASSES, LAYOUTS, type NewProgram } from '../editing/new-program.js';
import { messages } from '../messages/index.js';
import { Choice } from './choice.js';
import { SegmentChoice } from './segment-choice.js';
import './layout-choice.css';

interface LayoutChoiceProps {
  readonly wanted: NewProgram;
  readonly onChoose: (part: Partial<NewProgram>) => void;
}

/** For which timer a program is made: its class, and how many functions and servos it has. */
export function LayoutChoice({ wanted, onChoose }: LayoutChoiceProps) {
  const { newProgram: words, classNames } = messages.value;
  return (
    <>
      <SegmentChoice
        name="new-class"
        title={words.timerClass}
        choices={CLASSES}
        names={classNames as Record<(typeof CLASSES)[number], string>}
        chosen={wanted.timerClass}
        onChoose={(timerClass) => onChoose({ timerClass })}
      />
      <div class="layout-choice">
        <Choice
          label={words.functions}
          choices={countsIn(LAYOUTS.functions)}
          // The wire counts DT as a function; a pilot does not.
          nameOf={(count) => String(count - 1)}
          chosen={wanted.functions}
          onChoose={(functions) => onChoose({ functions })}
        />
        <Choice
          label={words.servos}
          choices={countsIn(LAYOUTS.servos)}
          nameOf={String}
          chosen={wanted.servos}
          onChoose={(servos) => onChoose({ servos })}
        />
      </div>
    </>
  );
}

function countsIn([first, last]: readonly [first: number, last: number]): number[] {
  return Array.from({ length: last - first + 1 }, (_, at) => first + at);
}
