import { useSignal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { dateText, fieldInSentence, figureText, messages, timerName, valueText } from '../messages/index.js';
import { keyName } from '../messages/key-figures.js';
import { isSimulated } from '../session/knowledge.js';
import { openValues } from '../session/known.js';
import { kindKey } from '../session/record-keys.js';
import type { Session } from '../session/session.js';
import type { UnfinishedWrite } from '../storage/index.js';
import './uncertain-band.css';

/** How many values are named when neither DT nor the motor stop is among them. */
const NAMED = 2;

interface UncertainBandProps {
  readonly session: Session;
  /** Reads a memory that is not current. */
  readonly onLook: (memory: number) => void;
}

/** The uncertain content of timers, in every view, until a reading explains it. */
export function UncertainBand({ session, onLook }: UncertainBandProps) {
  const { knowledge: words } = messages.value;
  const all = session.knowledge.uncertain.value;
  if (all.length === 0) return null;
  return (
    <section class="uncertain" aria-live="assertive" aria-label={words.title}>
      {all.map((one) => (
        <UncertainMemory key={one.key} session={session} one={one} onLook={onLook} />
      ))}
    </section>
  );
}

/**
 * The same for a dialog, which covers the page: only about the connected timer, or without one about that of the
 * program on the screen.
 */
export function UncertainNote({ session }: { readonly session: Session }) {
  const shown = session.editor.identity.value;
  const isShown = (one: UnfinishedWrite): boolean =>
    !session.connection.value && shown !== null && isOfKind(one, shown, session.simulated.value);
  const here = session.knowledge.uncertain.value.filter((one) => isHere(session, one) || isShown(one));
  if (here.length === 0) return null;
  return (
    <div class="uncertain">
      {here.map((one) => (
        <p key={one.key}>{uncertainText(one, null)}</p>
      ))}
    </div>
  );
}

interface UncertainMemoryProps extends UncertainBandProps {
  readonly one: UnfinishedWrite;
}

function UncertainMemory({ session, one, onLook }: UncertainMemoryProps) {
  const { knowledge: words } = messages.value;
  const asking = useSignal(false);
  const { identity } = one.before;
  const { status } = session.link.state.value;
  // While the page waits for an adapter, this would be the only button, and the wrong thing to do.
  const isSettled = status === 'off' || status === 'on';
  const named = words[isLikeConnected(session, one) ? 'otherTimer' : 'timer'];
  const timer = isHere(session, one) ? null : named(timerName(identity), identity.firmware, isSimulated(one));
  return (
    <div class="uncertain-one">
      <p>
        <strong>{uncertainText(one, timer)}</strong> <span class="since">{words.since(dateText(one.startedAt))}</span>
      </p>
      {asking.value && <p>{words.forgetSure}</p>}
      <div class="buttons">
        {asking.value ? (
          <>
            <button type="button" onClick={() => (asking.value = false)}>
              {words.keep}
            </button>
            <button type="button" onClick={() => void session.knowledge.forget(one.key)}>
              {words.forgetNow}
            </button>
          </>
        ) : (
          <>
            <WayToRead session={session} one={one} onLook={onLook} />
            {isSettled && (
              <button type="button" class="quiet" onClick={() => (asking.value = true)}>
                {words.forget}
              </button>
            )}
          </>
        )}
      </div>
    </div>
  );
}

/** The button that makes it certain, where that is possible from here. */
function WayToRead({ session, one, onLook }: UncertainMemoryProps) {
  const { knowledge: words, program, look, memoryName } = messages.value;
  const { memory } = one.before;
  const busy = session.runner.busy.value;
  if (isHere(session, one)) {
    const isCurrent = memory === null || session.editor.working.value?.memory === memory;
    return (
      <button type="button" disabled={busy} onClick={() => (isCurrent ? void session.reader.read() : onLook(memory))}>
        {isCurrent ? program.read : look.look(memoryName(memory))}
      </button>
    );
  }
  if (session.link.state.value.status !== 'off' || session.link.unavailable || isSimulated(one)) return null;
  return (
    <button type="button" disabled={session.engaged.value} onClick={() => void session.timer.connect()}>
      {words.connect}
    </button>
  );
}

/** Whether the connected timer may be that timer: it is of the same kind, and the pilot has not said otherwise. */
function isHere(session: Session, one: UnfinishedWrite): boolean {
  return isLikeConnected(session, one) && !session.knowledge.isOfOther(one.key);
}

function isLikeConnected({ connection, link }: Session, one: UnfinishedWrite): boolean {
  return connection.value !== null && isOfKind(one, connection.value.identity, link.simulated.value);
}

function isOfKind(one: UnfinishedWrite, identity: Identity, simulated: boolean): boolean {
  return kindKey(one.before.identity, isSimulated(one)) === kindKey(identity, simulated);
}

/**
 * “It is not known what M1 holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.”
 * @param timer null for the connected one.
 */
function uncertainText(one: UnfinishedWrite, timer: string | null): string {
  const { knowledge: words, memoryName } = messages.value;
  const { identity, memory } = one.before;
  const open = openValues(one);
  const isKey = ({ field }: { field: ProgramField }): boolean => keyName(identity, field) !== null;
  const keyed = open.filter(isKey);
  const named = keyed.length > 0 ? keyed : open.slice(0, NAMED);
  const shown = (field: ProgramField, value: number | null): string =>
    value === null ? valueText(identity, field, value) : figureText(identity, field, value);
  const values = named.map(({ field, from, to }) => {
    return words.either(fieldInSentence(identity, field), shown(field, from), shown(field, to));
  });
  const name = memory === null ? words.thisMemory : memoryName(memory);
  const where = timer === null ? name : words.memoryOf(name, timer);
  return `${words.uncertain(where, words.list(values, open.length - named.length))} ${words.noFly}`;
}
