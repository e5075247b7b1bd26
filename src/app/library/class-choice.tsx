import { useId } from 'preact/hooks';
import { CLASSES } from '../editing/new-program.js';
import { moreMessages } from '../messages/more.js';
import { timerName } from '../messages/names.js';
import { SegmentChoice } from '../ui/segment-choice.js';

const NONE = '';

interface ClassChoiceProps {
  /** An unusual class is offered beside the usual ones. */
  readonly value: string | null;
  readonly onChange: (timerClass: string | null) => void;
}

/** The class of a model's timer. */
export function ClassChoice({ value, onChange }: ClassChoiceProps) {
  const { model: words } = moreMessages.value.library;
  const name = useId();
  const choices = [...new Set<string>([...CLASSES, ...(value === null ? [] : [value]), NONE])];
  const names = Object.fromEntries(
    choices.map((each) => [each, each === NONE ? words.noClass : timerName({ timerClass: each })]),
  );
  return (
    <SegmentChoice
      name={name}
      title={words.timerClass}
      choices={choices}
      names={names}
      chosen={value ?? NONE}
      onChoose={(choice) => onChange(choice === NONE ? null : choice)}
    />
  );
}
