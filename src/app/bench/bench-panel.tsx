import { type Identity, slotCount } from '../../protocol/index.js';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import type { Session } from '../work/session.js';
import { SafetyCheck } from '../write/safety-check.js';
import type { Bench } from './bench.js';
import { BenchGrid } from './bench-grid.js';
import { Jump, Motor } from './bench-motor.js';
import { doneText } from './bench-text.js';
import { BenchTrim } from './bench-trim.js';
import type { Follow } from './follow.js';
import { FollowNote, FollowSwitch } from './follow-panel.js';
import './bench-panel.css';

export interface BenchPanelProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  /** Whether the pilot wants to see what few need. */
  readonly expert: boolean;
}

/**
 * The bench: move the servos to a function, let them follow, free the motor. Nothing is sent before the pilot has said
 * that it is safe.
 */
export function BenchPanel({ session, bench, follow, expert }: BenchPanelProps) {
  const identity = session.editor.identity.value;
  if (!identity) return null;
  const connected = session.connection.value !== null;
  return (
    <div class="stack gap-4 bench">
      {connected && <Elsewhere session={session} />}
      {connected ? <SafetyCheck safety={session.safety} /> : <p class="hint">{messages.value.views.noTimer.bench}</p>}
      {/* The switch itself says that they follow. */}
      {!follow.on.value && <FollowNote session={session} bench={bench} follow={follow} />}
      <div class="stack gap-4 bench-stage">
        {/* Above the grid, which is longer than the window of a phone. */}
        {connected && <FollowSwitch bench={bench} follow={follow} identity={identity} />}
        <div class="stack gap-3 bench-work">
          <Said bench={bench} identity={identity} />
          <BenchGrid session={session} bench={bench} />
        </div>
        {connected && <BenchTrim session={session} bench={bench} follow={follow} />}
        {connected && (
          <div class="stack gap-4">
            {identity.timerClass === 'Q' && <Motor {...{ session, bench, follow }} />}
            {expert && <Jump bench={bench} />}
          </div>
        )}
      </div>
    </div>
  );
}

/** Why nothing moves while another memory than the one that flies next is on the screen. */
function Elsewhere({ session }: Pick<BenchPanelProps, 'session'>) {
  const { bench: words } = messages.value;
  const memory = session.nextFlight.memory.value;
  if (!session.onScreen.apart.value || memory === null) return null;
  return <p class="notice">{words.elsewhere({ memory: memoryName(memory) })}</p>;
}

/** Announces what was done last, once it is done, with buttons to the previous and the next function. */
function Said({ bench, identity }: { readonly bench: Bench; readonly identity: Identity }) {
  const { previous, next } = messages.value;
  const { value: done } = bench.done;
  const at = bench.stand.at.value;
  const last = at ?? (done?.action.kind === 'move' ? done.action.slot : null);
  const steps = [
    { name: previous, to: last === null ? -1 : last - 1 },
    { name: next, to: last === null ? 0 : last + 1 },
  ];
  return (
    <div class="row">
      <p class={`bench-said ${done && !done.certain ? 'bad-text' : ''}`} role="status">
        {doneText(identity, done, at)}
      </p>
      {steps.map(({ name, to }) => {
        const can = bench.ready.value && to >= 0 && to < slotCount(identity);
        return (
          // Not disabled: it would lose the focus while the servos move.
          <button type="button" key={name} aria-disabled={!can} onClick={() => void (can && bench.moveTo(to))}>
            {name}
          </button>
        );
      })}
    </div>
  );
}
