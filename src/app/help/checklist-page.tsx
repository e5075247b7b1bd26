import { useSignal } from '@preact/signals';
import { useEffect, useId } from 'preact/hooks';
import { checklist as words } from '../messages/en-guide.js';
import { clockText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import type { Session } from '../session/session.js';
import { useUnsaved } from '../ui/unsaved.js';
import { type Checklist, LONGEST_OWN, ownKey } from './checklist.js';
import './checklist-page.css';

interface ChecklistPageProps {
  readonly checklist: Checklist;
  readonly session: Session;
}

/** What a pilot checks before a flight, one tick after the other. */
export function ChecklistPage({ checklist, session }: ChecklistPageProps) {
  const ticked = checklist.ticked.value;
  const left = checklist.left.value;
  useEffect(() => checklist.enter(), [checklist]);
  // A new version must not take the ticks away in the middle.
  useUnsaved(checklist.begun.value);
  const check = (key: string, text: string, why = '') => (
    <label class={ticked.has(key) ? 'check ticked' : 'check'}>
      <input
        type="checkbox"
        checked={ticked.has(key)}
        onChange={({ currentTarget }) => checklist.tick(key, currentTarget.checked)}
      />
      <span>
        {text} {why !== '' && <small>{why}</small>}
      </span>
    </label>
  );
  return (
    <div class="checklist">
      <p>{words.lead}</p>
      <ul>
        {checklist.items.value.map((id) => (
          <li key={id}>
            {check(id, words.items[id].text, words.items[id].why)}
            {id === 'memory' && <Known session={session} />}
          </li>
        ))}
        {checklist.own.value.map((text) => (
          <li key={ownKey(text)} class="own">
            {check(ownKey(text), text)}
            <button
              type="button"
              class="quiet"
              aria-label={words.own.remove(text)}
              onClick={() => checklist.remove(text)}
            >
              {words.own.removeShort}
            </button>
          </li>
        ))}
      </ul>
      <div class="checklist-foot">
        <p class={left === 0 ? 'all-done' : ''} role="status">
          {left === 0 ? words.done : words.left(left)}
        </p>
        <button type="button" disabled={ticked.size === 0} onClick={() => checklist.clear()}>
          {words.again}
        </button>
      </div>
      <OwnItem checklist={checklist} />
    </div>
  );
}

/** What is known about the connected timer: the memory that flies next, and its DT. */
function Known({ session }: Pick<ChecklistPageProps, 'session'>) {
  const { memoryName } = messages.value;
  const { known } = words;
  const { editor, nextFlight, connection, simulated } = session;
  const held = editor.baseline.value;
  const standing = session.standing.value;
  if (!held) return <p class="known-now hint">{known.nothing}</p>;
  const memory = held.memory === null ? known.memory : memoryName(held.memory);
  if (standing.sure === 'not') {
    return (
      <p class="known-now bad-text" role="alert">
        {known.not(memory)}
      </p>
    );
  }
  const [dt] = keyFigures(held);
  const changes = editor.changes.value.length;
  const time = standing.at === null ? null : clockText(standing.at);
  // Which memory flies next is certain only while the timer is connected.
  const flies = standing.sure === 'now' && time !== null && connection.value !== null && !nextFlight.open.value;
  const isCertain = flies && held.memory !== null;
  return (
    <p class="known-now">
      {isCertain ? known.now(memory, dt?.text ?? '', time) : known.once(memory, dt?.text ?? '', time)}{' '}
      {changes > 0 && <span class="bad-text">{known.unwritten(changes)}</span>} {simulated.value && known.simulated}
    </p>
  );
}

/** Adds an item of the pilot's own. */
function OwnItem({ checklist }: Pick<ChecklistPageProps, 'checklist'>) {
  const text = useSignal('');
  const refused = useSignal(false);
  const id = useId();
  return (
    <form
      class="own-item"
      onSubmit={(event) => {
        event.preventDefault();
        if (text.value.trim() === '') return;
        refused.value = !checklist.add(text.value);
        if (!refused.value) text.value = '';
      }}
    >
      <label for={id}>{words.own.label}</label>
      <span class="buttons">
        <input
          id={id}
          type="text"
          maxLength={LONGEST_OWN}
          autocomplete="off"
          value={text.value}
          aria-describedby={`${id}-hint`}
          onInput={({ currentTarget }) => {
            text.value = currentTarget.value;
            refused.value = false;
          }}
        />
        <button type="submit">{words.own.add}</button>
      </span>
      <p id={`${id}-hint`} class={refused.value ? 'bad-text' : 'hint'} role={refused.value ? 'alert' : undefined}>
        {refused.value ? words.own.refused : words.own.hint}
      </p>
    </form>
  );
}
