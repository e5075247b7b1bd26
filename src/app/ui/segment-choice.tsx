import './segment-choice.css';

interface SegmentChoiceProps<T extends string> {
  /** The name of the group of radio buttons. */
  readonly name: string;
  readonly title: string;
  readonly choices: readonly T[];
  readonly names: Readonly<Record<T, string>>;
  readonly chosen: T;
  readonly onChoose: (choice: T) => void;
}

/** A choice of a few buttons, one tap each: in the sun nobody can read a menu. */
export function SegmentChoice<T extends string>(props: SegmentChoiceProps<T>) {
  const { name, title, choices, names, chosen, onChoose } = props;
  return (
    <fieldset class="row segment-choice">
      <legend class="hint">{title}</legend>
      <div class="segments">
        {choices.map((choice) => (
          <label key={choice}>
            <input
              type="radio"
              name={name}
              class="visually-hidden"
              checked={choice === chosen}
              onChange={() => onChoose(choice)}
            />
            <span>{names[choice]}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
