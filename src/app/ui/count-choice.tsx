interface CountChoiceProps {
  readonly label: string;
  readonly range: readonly [first: number, last: number];
  readonly value: number;
  readonly shown?: (count: number) => number;
  readonly onChoose: (count: number) => void;
}

/** Chooses a small number from a list. */
export function CountChoice({
  label,
  range: [first, last],
  value,
  shown = (count) => count,
  onChoose,
}: CountChoiceProps) {
  return (
    <label class="choice">
      <span>{label}</span>
      <select value={String(value)} onChange={(event) => onChoose(Number(event.currentTarget.value))}>
        {Array.from({ length: last - first + 1 }, (_, at) => first + at).map((count) => (
          <option key={count} value={String(count)}>
            {shown(count)}
          </option>
        ))}
      </select>
    </label>
  );
}
