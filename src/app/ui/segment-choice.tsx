import './segment-choice.css';

interface SegmentChoiceProps<T extends string> {
  /** The name of the group of radio buttons. */
  readonly name: string;
  readonly title: string;
  readonly choices: readonly T[];
  readonly names: Readonly<Record<T, string>>;
  readonly chosen: T;
  readonly onChoose: (choice: T) => void;
  /** Whether choosing starts a job: then arrow keys move only the focus, and Space, Enter or a click chooses. */
  readonly isSlow?: boolean;
}

const STEPS: Readonly<Record<string, 1 | -1>> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

function onKeyDown(event: KeyboardEvent): void {
  const { key, currentTarget, ctrlKey, altKey, metaKey } = event;
  if (ctrlKey || altKey || metaKey || !(currentTarget instanceof HTMLInputElement)) return;
  const step = STEPS[key];
  if (step !== undefined) {
    event.preventDefault();
    const all = [...(currentTarget.closest('.segments')?.querySelectorAll('input') ?? [])];
    all.at((all.indexOf(currentTarget) + step) % all.length)?.focus();
  } else if (key === 'Enter') {
    event.preventDefault();
    currentTarget.click();
  }
}

/** A choice of a few buttons, one tap each: in the sun nobody can read a menu. */
export function SegmentChoice<T extends string>(props: SegmentChoiceProps<T>) {
  const { name, title, choices, names, chosen, onChoose, isSlow } = props;
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
              onKeyDown={isSlow ? onKeyDown : undefined}
            />
            <span>{names[choice]}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
