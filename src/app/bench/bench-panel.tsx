import { useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { type Identity, slotCount } from '../../protocol/index.js';
import { messages, slotLabel } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { HoldButton } from '../ui/hold-button.js';
import { SafetyCheck } from '../write/safety-check.js';
import type { Bench } from './bench.js';
import { doneText } from './bench-text.js';
import type { Follow } from './follow.js';
import { FollowSwitch } from './follow-panel.js';
import './bench-panel.css';

export interface BenchPanelProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
}

/**
 * The timer on the bench: servos to a function, servos that follow, the motor. Nothing of it goes out before the pilot
 * has said that it is safe.
 */
export function BenchPanel({ session, bench, follow }: BenchPanelProps) {
  const identity = session.editor.identity.value;
  if (!identity) return null;
  return (
    <div class="bench">
      <Controls session={session} bench={bench} follow={follow} identity={identity} />
    </div>
  );
}

interface ControlsProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  readonly identity: Identity;
}

function Controls({ session, bench, follow, identity }: ControlsProps) {
  const { bench: words } = messages.value;
  const connected = session.connection.value !== null;
  return (
    <>
      <p class="hint">{connected ? words.lead : words.notConnected}</p>
      {connected && <SafetyCheck safety={session.safety} />}
      <Said bench={bench} identity={identity} />
      {connected && <Slots bench={bench} identity={identity} />}
      {connected && <FollowSwitch bench={bench} follow={follow} identity={identity} />}
      {connected && identity.timerClass === 'Q' && <Motor bench={bench} />}
      {connected && <Experimental bench={bench} />}
    </>
  );
}

/** What was done last, said when it is done. */
function Said({ bench, identity }: { readonly bench: Bench; readonly identity: Identity }) {
  const { value } = bench.done;
  return (
    <p class={`bench-said ${value && !value.certain ? 'bad-text' : ''}`} role="status">
      {doneText(identity, value, bench.stand.at.value)}
    </p>
  );
}

/** Start to DT, and steps from one to the next. */
function Slots({ bench, identity }: { readonly bench: Bench; readonly identity: Identity }) {
  const { bench: words } = messages.value;
  const ready = bench.ready.value;
  const at = bench.stand.at.value;
  const action = bench.done.value?.action;
  const last = at ?? (action?.kind === 'move' ? action.slot : null);
  const count = slotCount(identity);
  const go = (slot: number) => () => void (ready && bench.moveTo(slot));
  return (
    <fieldset class="bench-slots">
      <legend>{words.slots}</legend>
      <div class="bench-steps">
        {[
          { name: words.previous, to: last === null ? null : last - 1, path: 'M12 4L6 10L12 16' },
          { name: words.next, to: last === null ? 0 : last + 1, path: 'M8 4L14 10L8 16' },
        ].map(({ name, to, path }) => {
          const can = ready && to !== null && to >= 0 && to < count;
          return (
            // Not disabled: it would lose the focus while the servos move.
            <button type="button" key={name} aria-disabled={!can} onClick={can ? go(to) : undefined}>
              <svg class="icon" width="20" height="20" aria-hidden="true">
                <path d={path} />
              </svg>
              {name}
            </button>
          );
        })}
      </div>
      <div class="bench-grid">
        {Array.from({ length: count }, (_, slot) => (
          <button
            type="button"
            key={slotLabel(identity, slot)}
            aria-label={slotLabel(identity, slot)}
            aria-pressed={slot === at}
            aria-disabled={!ready}
            onClick={go(slot)}
          >
            {slot === 0 || slot === identity.functions ? slotLabel(identity, slot) : slot}
          </button>
        ))}
      </div>
    </fieldset>
  );
}

function Motor({ bench }: { readonly bench: Bench }) {
  const { bench: words } = messages.value;
  const id = useId();
  return (
    <section>
      <h2>{words.motor}</h2>
      <p class="bad-text" id={id}>
        {words.unlockHint}
      </p>
      <HoldButton
        label={words.unlock}
        holding={words.unlockHold}
        describedBy={id}
        disabled={!bench.ready.value}
        onHeld={() => void bench.unlock()}
      />
    </section>
  );
}

/** What is not documented, asked for twice. */
function Experimental({ bench }: { readonly bench: Bench }) {
  const { bench: words } = messages.value;
  const asked = useSignal(false);
  return (
    <details>
      <summary>{words.experimental}</summary>
      <p class="hint">{words.jumpHint}</p>
      <div class="buttons">
        {asked.value ? (
          <>
            <button
              type="button"
              disabled={!bench.ready.value}
              onClick={() => {
                asked.value = false;
                void bench.jump();
              }}
            >
              {words.jumpSure}
            </button>
            <button
              type="button"
              onClick={() => {
                asked.value = false;
              }}
            >
              {words.cancel}
            </button>
          </>
        ) : (
          <button
            type="button"
            disabled={!bench.ready.value}
            onClick={() => {
              asked.value = true;
            }}
          >
            {words.jump}
          </button>
        )}
      </div>
    </details>
  );
}
