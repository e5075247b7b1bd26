interface ProblemProps {
  /** Nothing is shown for null, false, or an empty text. */
  readonly text: string | null | false;
}

/** What went wrong, said at once. */
export function Problem({ text }: ProblemProps) {
  return text ? (
    <p class="bad-text" role="alert">
      {text}
    </p>
  ) : null;
}
