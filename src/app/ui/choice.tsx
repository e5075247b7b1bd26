interface SelectProps<T extends string | number | boolean | null> {
  /** Its name, where no label stands around it. */
  readonly name?: string;
  readonly choices: readonly T[];
  readonly nameOf: (choice: T) => string;
  readonly chosen: T;
  readonly onChoose: (choice: T) => void;
}

/** Chooses one value from a list. */
export function Select<T extends string | number | boolean | null>(props: SelectProps<T>) {
  const { name, choices, nameOf, chosen, onChoose } = props;
  const textOf = (choice: T): string => String(choice ?? '');
  return (
    <select
      aria-label={name}
      value={textOf(chosen)}
      onChange={({ currentTarget: { value } }) => {
        const found = choices.findIndex((choice) => textOf(choice) === value);
        if (found >= 0) onChoose(choices[found] as T);
      }}
    >
      {choices.map((choice) => (
        <option key={textOf(choice)} value={textOf(choice)}>
          {nameOf(choice)}
        </option>
      ))}
    </select>
  );
}

/** The same with its name above it. */
export function Choice<T extends string | number | boolean | null>({
  label,
  ...select
}: SelectProps<T> & { readonly label: string }) {
  return (
    <label class="field">
      <span>{label}</span>
      <Select {...select} />
    </label>
  );
}
