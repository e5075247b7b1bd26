import type { Ambiguous } from '../editing/units.js';
import { eitherTexts, messages } from '../messages/index.js';
import './time-question.css';

interface TimeQuestionProps {
  /** Of the field in which the text stands. */
  readonly label: string;
  readonly either: Ambiguous['either'];
  /** @param byKey the focus has to go somewhere then. */
  readonly onAnswer: (value: number, byKey: boolean) => void;
  readonly onEscape: () => void;
}

/** A text in a field that can be read in several ways: one of them is chosen, or Escape takes the text back. */
export function TimeQuestion({ label, either, onAnswer, onEscape }: TimeQuestionProps) {
  const texts = eitherTexts(either);
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is no part of a line of text, and this stands in one.
    <span
      class="time-question"
      role="group"
      aria-label={messages.value.times.meaning(label)}
      // The focus stays in the field, for which it may be asked only while it has it.
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
