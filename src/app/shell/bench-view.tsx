import type { ComponentChildren } from 'preact';
import type { Bench } from '../bench/bench.js';
import { BenchPanel } from '../bench/bench-panel.js';
import type { Follow } from '../bench/follow.js';
import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import type { Views } from './views.js';

export interface BenchViewProps {
  readonly session: Session;
  readonly views: Views;
  readonly bench: Bench;
  readonly follow: Follow;
  /** The button that connects a timer. */
  readonly connect: ComponentChildren;
}

/** The bench; without a program, a sentence that asks for a timer, and the button for it. */
export function BenchView({ session, views, bench, follow, connect }: BenchViewProps) {
  const { names, noTimer } = messages.value.views;
  const hasProgram = session.editor.identity.value !== null;
  return (
    <>
      <h1>{names.bench}</h1>
      {hasProgram ? (
        <BenchPanel {...{ session, bench, follow }} expert={views.expert.value} />
      ) : (
        <>
          <p class="hint">{noTimer.bench}</p>
          <div>{connect}</div>
        </>
      )}
    </>
  );
}
