import { useId } from 'preact/hooks';
import { fieldKey, type TimerProgram } from '../../program/index.js';
import { clockText, fieldInSentence, figureText, messages } from '../messages/index.js';
import { keyFields } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import type { Scale } from '../timeline/scale.js';
import { SmallLanes, sharedScale } from '../timeline/small-lanes.js';
import { type Known, lastRead, possibleValues } from '../timer/known.js';
import { PlaneIcon } from '../ui/plane-icon.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from '../write/write-job.js';
import type { Memories } from './memories.js';
import { MemoryName } from './memory-name.js';
import './memory-cards.css';

interface MemoryCardsProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly write: WriteJob;
  /** Shows the program of the memory that was picked last. */
  readonly onProgram: () => void;
  /** Shows two memories side by side. */
  readonly onCompare: (first: number, second: number) => void;
}

/** A card for each memory: its last reading, whether it flies next, and what can be done with it. */
export function MemoryCards({ session, memories, write, onProgram, onCompare }: MemoryCardsProps) {
  const baseline = session.editor.baseline.value;
  if (!baseline) return null;
  // Without a timer, the one that was on the screen.
  const last = session.onScreen.apart.value ? null : baseline.memory;
  const current = session.connection.value ? session.nextFlight.memory.value : last;
  const count = baseline.identity.memories;
  const all = Array.from({ length: count }, (_, memory) => ({ memory, ...session.standings.of(memory) }));
  const scale = sharedScale(all.flatMap(({ known }) => lastRead(known) ?? []));
  return (
    <ul class="memory-cards">
      {all.map((each) => (
        <Card
          key={each.memory}
          {...each}
          {...{ session, memories, write, current, count, scale, onProgram, onCompare }}
        />
      ))}
    </ul>
  );
}

interface CardProps extends MemoryCardsProps {
  readonly memory: number;
  /** The current memory of the timer; null when it is not known. */
  readonly current: number | null;
  /** How many memories the timer has. */
  readonly count: number;
  readonly known: Known;
  /** The time axis of all cards. */
  readonly scale: Scale;
}

function Card({ known, scale, ...props }: CardProps) {
  const { session, memories, memory, current } = props;
  const { look, nextFlight } = messages.value;
  const { overview: words } = moreMessages.value;
  const title = useId();
  // The button that reads it goes, and so does the one that makes it fly next.
  const box = useHandedFocus('.card-actions button');
  const isCurrent = memory === current;
  const isConnected = session.connection.value !== null;
  const program = lastRead(known);
  return (
    <li>
      <article {...box} class={`stack panel memory-card ${isCurrent ? 'current' : ''}`} aria-labelledby={title}>
        <header class="row">
          <h2 id={title}>{memoryName(memory)}</h2>
          <MemoryName session={session} memory={memory} />
          {isCurrent && isConnected && (
            <span class="badge">
              <PlaneIcon /> {nextFlight.badge}
            </span>
          )}
          {program && <Figures {...{ session, known, program }} />}
          {known.state === 'uncertain' ? (
            <p class="bad-text">{words.notCertain}</p>
          ) : (
            <p class="hint">
              {known.state === 'read'
                ? words.readAt({ time: clockText(known.at) })
                : look.notRead({ memory: memoryName(memory) })}
            </p>
          )}
        </header>
        {program ? <SmallLanes {...{ program, scale }} /> : <Unread {...{ session, memories, memory, current }} />}
        <Actions {...props} isRead={program !== null} />
      </article>
    </li>
  );
}

interface FiguresProps extends Pick<CardProps, 'session' | 'known'> {
  readonly program: TimerProgram;
}

/** “DT 3:00 min · motor stop 10.0 s”. After an interrupted write there may be two of each. */
function Figures({ session, known, program: { identity } }: FiguresProps) {
  const { look, program: names } = messages.value;
  return (
    <p class="row card-figures">
      {keyFields(identity).map((field, at) => {
        const values = possibleValues(known, field);
        const texts = values.map((value) => figureText(identity, field, value));
        // DT comes first.
        const isShort = at === 0 && values.every((value) => value < session.editor.shortDt.value);
        const name = isShort ? names.shortDt : fieldInSentence(identity, field);
        return (
          <span key={fieldKey(field)} class={isShort ? 'bad-text' : ''}>
            {name} {texts.join(` ${look.or} `)}
          </span>
        );
      })}
    </p>
  );
}

type UnreadProps = Pick<CardProps, 'session' | 'memories' | 'memory' | 'current'>;

/** In place of a picture, for a memory that nobody has read: a button that reads it and comes back. */
function Unread({ session, memories, memory, current }: UnreadProps) {
  const { look, timer } = messages.value;
  const isBusy = !session.runner.ready.value;
  const name = memoryName(memory);
  return (
    <div class="stack card-unread">
      {/* Not disabled: it would lose the focus during the reading. */}
      <button
        type="button"
        aria-disabled={isBusy || current === null}
        onClick={() => void (!isBusy && current !== null && memories.readOnce(memory))}
      >
        {look.look({ memory: name })}
      </button>
      {current !== null && <p class="hint">{look.hint({ memory: name, current: memoryName(current) })}</p>}
      {memories.noWayBack.value && <p class="hint">{timer['memory-unknown'].advice}</p>}
    </div>
  );
}

interface ActionsProps extends Omit<CardProps, 'known' | 'scale'> {
  readonly isRead: boolean;
}

function Actions({ session, memories, write, memory, current, count, isRead, onProgram, onCompare }: ActionsProps) {
  const { memories: all, look, of, open } = messages.value;
  const { overview: words } = moreMessages.value;
  const ready = session.runner.ready.value;
  const name = memoryName(memory);
  const others = Array.from({ length: count }, (_, other) => other).filter((other) => other !== memory);
  // With the memory that flies next; that one with the first of the others.
  const against = memory === current || current === null ? others[0] : current;
  // What is not certain has no one program to compare.
  const canCompare = (each: number): boolean => session.standings.of(each).known.state === 'read';
  const edits = memory !== current && current !== null && session.connection.value !== null;
  return (
    <div class="row card-actions">
      {edits && (
        <button
          type="button"
          aria-disabled={!ready}
          onClick={() => {
            if (!ready) return;
            void memories.edit(memory);
            onProgram();
          }}
        >
          {look.edit({ memory: name })}
        </button>
      )}
      {!edits && (isRead || memory === current) && (
        <button
          type="button"
          aria-label={of({ button: open, name })}
          onClick={() => {
            void memories.show(memory);
            onProgram();
          }}
        >
          {open}
        </button>
      )}
      {memory !== current && (
        <button type="button" aria-disabled={!ready} onClick={() => void (ready && memories.fly(memory))}>
          {look.fly({ memory: name })}
        </button>
      )}
      {against !== undefined && canCompare(memory) && canCompare(against) && (
        <button
          type="button"
          class="quiet"
          aria-label={of({ button: words.compareWith({ memory: memoryName(against) }), name })}
          onClick={() => onCompare(memory, against)}
        >
          {words.compareWith({ memory: memoryName(against) })}
        </button>
      )}
      {others.length > 0 && (
        <details class="copy-to">
          <summary aria-label={of({ button: words.copyTo, name })}>{words.copyTo}</summary>
          {/* A timer may have 255 memories. */}
          <div class="segments">
            {others.map((to) => (
              <button
                type="button"
                key={to}
                aria-label={all.copy({ from: name, to: memoryName(to) })}
                disabled={!ready || current === null}
                onClick={() => void write.open({ kind: 'copy', from: memory, to })}
              >
                {memoryName(to)}
              </button>
            ))}
          </div>
        </details>
      )}
    </div>
  );
}
