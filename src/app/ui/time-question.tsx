import type { Ambiguous } from '../editing/units.js';
import { eitherTexts, messages } from '../messages/index.js';
import './time-question.css';

interface TimeQuestionProps {
  /** The label of the field with the text. */
  readonly label: string;
  readonly either: Ambiguous['either'];
  /** @param byKey whether the keyboard was used, so that the focus has to go somewhere. */
  readonly onAnswer: (value: number, byKey: boolean) => void;
  readonly onEscape: () => void;
}

/** A question about an ambiguous text in a field: the pilot chooses a meaning, or takes the text back with Escape. */
export function TimeQuestion({ label, either, onAnswer, onEscape }: TimeQuestionProps) {
  const texts = eitherTexts(either);
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is no part of a line of text, and this stands in one.
    <span
      class="time-question"
      role="group"
      aria-label={messages.value.times.meaning({ field: label })}
      // The focus stays in the field: the question may exist only while the field has it.
      onPointerDown={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        event.preventDefault();
        onEscape();
      }}
    >
      {either.map((value, at) => (
        <button type="button" key={value} onClick={({ detail }) => onAnswer(value, detail === 0)}>
          {texts[at]}
        </button>
      ))}
    </span>
  );
}
