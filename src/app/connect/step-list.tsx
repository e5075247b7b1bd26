import type { ComponentChildren } from 'preact';
import './step-list.css';

export interface StepRow {
  readonly key: string;
  readonly text: string;
  /** Whether this step is done. */
  readonly done?: boolean;
  /** Whether this is the step to take now. */
  readonly now?: boolean;
  /** A control that belongs to the step. */
  readonly action?: ComponentChildren;
}

/** Steps to take, one after the other. Finished steps have a tick. */
export function StepList({ steps }: { readonly steps: readonly StepRow[] }) {
  return (
    <ol class="stack gap-3 step-list">
      {steps.map(({ key, text, done = false, now = false, action }) => (
        <li key={key} class={done ? 'done' : ''} aria-current={now ? 'step' : undefined}>
          {done && <Tick />}
          <span>{text}</span>
          {action}
        </li>
      ))}
    </ol>
  );
}

/** A tick, for the eye only. */
export function Tick() {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="18" height="18" aria-hidden="true">
      <path d="M5 12.5l4.5 4.5L19 7.5" />
    </svg>
  );
}
