import { useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { fieldKey } from '../../program/index.js';
import { columnCount, type Identity } from '../../protocol/index.js';
import { columnLabel, fieldLabel, messages } from '../messages/index.js';
import { useModels } from '../models.js';
import type { Done } from '../state/bench.js';
import { HoldButton } from './hold-button.js';
import { SafetyCheck } from './safety-check.js';

/** The timer on the bench: servos to a function, servos that follow, the motor. Nothing of it goes out before the pilot has said that it is safe. */
export function BenchPanel() {
  const { session } = useModels();
  const { bench: words } = messages.value;
  const open = useSignal(false);
  const identity = session.editor.identity.value;
  if (!identity) return null;
  return (
    <details
      class="bench"
      onToggle={(event) => {
        open.value = event.currentTarget.open;
      }}
    >
      <summary>{words.title}</summary>
      {open.value && <Controls identity={identity} />}
    </details>
  );
}

function Controls({ identity }: { identity: Identity }) {
  const { session } = useModels();
  const { bench: words } = messages.value;
  const connected = session.connection.value !== null;
  return (
    <>
      <p class="hint">{connected ? words.lead : words.notConnected}</p>
      {connected && <SafetyCheck />}
      <Said identity={identity} />
      {connected && <Columns identity={identity} />}
      {connected && <Follow />}
      {connected && identity.timerClass === 'Q' && <Motor />}
      {connected && <Experimental />}
    </>
  );
}

/** What was done last, said when it is done. */
function Said({ identity }: { identity: Identity }) {
  const { bench } = useModels();
  const { value } = bench.done;
  return (
    <p class={`bench-said ${value && !value.certain ? 'bad-text' : ''}`} role="status">
      {doneText(identity, value)}
    </p>
  );
}

function doneText(identity: Identity, done: Done | null): string {
  const { bench: words } = messages.value;
  if (!done) return words.atNone;
  const { action, certain } = done;
  if (action.kind === 'move') {
    const column = inSentence(columnLabel(identity, action.column));
    return certain ? words.at(column) : words.moveMaybe(column);
  }
  if (action.kind === 'unlock') return certain ? words.unlocked : words.unlockMaybe;
  return certain ? words.jumped : words.jumpMaybe;
}

/** “Servos at function 4”, but “Servos at DT”. */
function inSentence(label: string): string {
  return /^[A-Z][a-z]/.test(label) ? label.charAt(0).toLowerCase() + label.slice(1) : label;
}

/** Start to DT, and steps from one to the next. */
function Columns({ identity }: { identity: Identity }) {
  const { bench } = useModels();
  const { bench: words } = messages.value;
  const ready = bench.ready.value;
  const action = bench.done.value?.action;
  const at = action?.kind === 'move' ? action.column : null;
  const count = columnCount(identity);
  const go = (column: number) => () => void (ready && bench.moveTo(column));
  return (
    <fieldset class="bench-columns">
      <legend>{words.columns}</legend>
      <div class="bench-steps">
        {[
          { name: words.previous, to: at === null ? null : at - 1, path: 'M12 4L6 10L12 16' },
          { name: words.next, to: at === null ? 0 : at + 1, path: 'M8 4L14 10L8 16' },
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
        {Array.from({ length: count }, (_, column) => (
          <button
            type="button"
            key={columnLabel(identity, column)}
            aria-label={columnLabel(identity, column)}
            aria-pressed={column === at}
            aria-disabled={!ready}
            onClick={go(column)}
          >
            {column === 0 || column === identity.functions ? columnLabel(identity, column) : column}
          </button>
        ))}
      </div>
    </fieldset>
  );
}

/** The switch, and what becomes of what was tried. */
function Follow() {
  const { session, bench } = useModels();
  const { bench: words } = messages.value;
  const { editor } = session;
  const on = bench.following.value;
  const tried = bench.tried.value;
  const identity = editor.identity.value;
  if (!identity) return null;
  const open = !on && tried.length > 0;
  const isWaiting = on && editor.changes.value.some(({ field }) => !bench.trial.value?.touched.has(fieldKey(field)));
  return (
    <section class={`bench-follow ${on ? 'on' : ''}`}>
      <button
        type="button"
        class="switch"
        role="switch"
        aria-checked={on}
        aria-disabled={!on && (open || !bench.ready.value)}
        onClick={() => void (on ? bench.stopFollowing() : bench.follow())}
      >
        <span class="switch-track" aria-hidden="true" />
        {words.follow}
      </button>
      <p class="hint">{on ? words.followingNow : words.followHint}</p>
      {isWaiting && <p class="hint">{words.followPending}</p>}
      {(on || open) && <p role="status">{words.tried(tried.length)}</p>}
      {open && (
        <ul>
          {tried.map(({ field, from, to }) => (
            <li key={fieldKey(field)}>{words.triedOf(fieldLabel(identity, field), String(from), String(to))}</li>
          ))}
        </ul>
      )}
    </section>
  );
}

/** Where fields are edited it has to be in sight that they move the servos, and that a choice is open. */
export function FollowNote() {
  const { bench } = useModels();
  const { bench: words } = messages.value;
  const { length } = bench.tried.value;
  if (bench.following.value) {
    return (
      <div class="follow-note">
        <strong>{words.followingNow}</strong>
        <button type="button" onClick={() => void bench.stopFollowing()}>
          {words.stopFollowing}
        </button>
      </div>
    );
  }
  if (length === 0) return null;
  return (
    <div class="follow-note">
      <strong>
        {words.tried(length)} {words.decide}
      </strong>
      <Decide />
    </div>
  );
}

function Decide() {
  const { session, bench, write } = useModels();
  const { bench: words } = messages.value;
  return (
    <div class="buttons">
      <button type="button" class="primary" onClick={() => bench.keep()}>
        {words.keep}
      </button>
      <button
        type="button"
        disabled={session.busy.value || session.editor.blocked.value}
        onClick={() => {
          session.editor.apply(bench.takeBack(), { code: 'restore', params: {} });
          void write.open();
        }}
      >
        {words.putBack}
      </button>
    </div>
  );
}

function Motor() {
  const { bench } = useModels();
  const { bench: words } = messages.value;
  const id = useId();
  return (
    <section class="bench-motor">
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
function Experimental() {
  const { bench } = useModels();
  const { bench: words } = messages.value;
  const asked = useSignal(false);
  return (
    <details class="bench-experimental">
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
