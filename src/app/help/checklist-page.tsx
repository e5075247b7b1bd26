import { useEffect } from 'preact/hooks';
import { whole } from '../messages/dotted.js';
import { clockText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { lastRead } from '../timer/known.js';
import type { Held } from '../timer/standing.js';
import { Check } from '../ui/check.js';
import { useUnsaved } from '../ui/unsaved.js';
import type { Session } from '../work/session.js';
import { graveText } from '../write/unfinished-text.js';
import type { Checklist } from './checklist.js';
import './checklist-page.css';

interface ChecklistPageProps {
  readonly checklist: Checklist;
  readonly session: Session;
}

/** What a pilot checks before a flight, one tick after the other. */
export function ChecklistPage({ checklist, session }: ChecklistPageProps) {
  const words = moreMessages.value.checklist;
  const ticked = checklist.ticked.value;
  const left = checklist.left.value;
  useEffect(() => checklist.enter(), [checklist]);
  // A new version must not take the ticks away in the middle.
  useUnsaved(checklist.begun.value);
  return (
    <div class="stack gap-3 checklist">
      <p>{words.lead}</p>
      <ul class="panel ruled">
        {checklist.items.value.map((id) => (
          <li key={id}>
            <Check checked={ticked.has(id)} onChange={(on) => checklist.tick(id, on)}>
              {words.items[id]}
            </Check>
            {id === 'memory' && <Known session={session} />}
          </li>
        ))}
      </ul>
      <div class="row between checklist-foot">
        <p class={left === 0 ? 'all-done' : ''} role="status">
          {left === 0 ? words.done : words.left({ count: left })}
        </p>
        <button type="button" disabled={ticked.size === 0} onClick={() => checklist.clear()}>
          {words.again}
        </button>
      </div>
    </div>
  );
}

const UNKNOWN: Held = { known: { state: 'unread' }, sure: 'once' };

/** What is known about the connected timer: the memory that flies next, and its DT. */
function Known({ session }: Pick<ChecklistPageProps, 'session'>) {
  const { knowledge, header } = messages.value;
  const { known } = moreMessages.value.checklist;
  const { editor, onScreen, nextFlight, connection, simulated } = session;
  // A memory that was opened apart from the one that flies next says nothing here.
  const isApart = onScreen.apart.value;
  const { known: next, sure } = session.standings.next.value ?? UNKNOWN;
  const held = isApart ? lastRead(next) : editor.baseline.value;
  const standing = isApart ? { sure, at: next.state === 'read' ? next.at : null } : session.standing.value;
  if (!held) {
    // Without a reading the worst that is unfinished is what there is to know.
    const [worst] = session.unfinished.value;
    const said = worst ? graveText(session, worst) : null;
    return <p class={`known-now ${said === null ? 'hint' : 'bad-text'}`}>{said ?? known.nothing}</p>;
  }
  const memory = held.memory === null ? knowledge.thisMemory : memoryName(held.memory);
  if (standing.sure === 'not') {
    return (
      <p class="known-now bad-text" role="alert">
        {known.not({ memory })}
      </p>
    );
  }
  const [dt] = keyFigures(held);
  const changes = isApart ? 0 : editor.changes.value.length;
  const time = standing.at === null ? null : clockText(standing.at);
  const figures = { memory, dt: whole(dt?.text ?? '') };
  // Which memory flies next is certain only while the timer is connected.
  const flies = standing.sure === 'now' && time !== null && connection.value !== null && !nextFlight.open.value;
  const isCertain = flies && held.memory !== null;
  return (
    <p class="known-now">
      {time === null ? known.once(figures) : known[isCertain ? 'now' : 'onceAt']({ ...figures, time })}{' '}
      {changes > 0 && <span class="bad-text">{known.unwritten({ count: changes })}</span>}{' '}
      {simulated.value && <span class="badge">{header.simulated}</span>}
    </p>
  );
}
