import './step-list.css';

export interface StepRow {
  readonly text: string;
  /** Whether this step is done. */
  readonly done?: boolean;
  /** Whether this is the step to take now. */
  readonly now?: boolean;
}

/** Steps to take, one after the other. Finished steps have a tick. */
export function StepList({ steps }: { readonly steps: readonly StepRow[] }) {
  return (
    <ol class="stack gap-3 step-list">
      {steps.map(({ text, done = false, now = false }) => (
        <li key={text} class={done ? 'done' : ''} aria-current={now ? 'step' : undefined}>
          {text}
        </li>
      ))}
    </ol>
  );
}
