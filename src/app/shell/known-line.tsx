import { useComputed } from '@preact/signals';
import type { Follow } from '../bench/follow.js';
import { clockText, messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import './known-line.css';

/** How the program on the screen stands to the timer: what differs, or that it is as it was read, and when. */
export function KnownLine({ session, follow }: { readonly session: Session; readonly follow: Follow }) {
  const { program, bench, knowledge: words, memoryName, strip } = messages.value;
  const { editor } = session;
  const count = useComputed(() => editor.changes.value.length).value;
  const unfinished = useComputed(() => editor.unreadable.value.size).value;
  const tried = useComputed(() => follow.trials.tried.value.length).value;
  const memory = useComputed(() => editor.working.value?.memory ?? null).value;
  const standing = session.standing.value;
  const time = standing.at === null ? null : clockText(standing.at);
  // Of no timer, but of the library.
  const kept = useComputed(() => {
    const opened = editor.madeAt.value === null ? null : session.opened.shown.value;
    if (!opened?.setting) return null;
    const { model, setting } = opened;
    return { model: model?.name, setting: setting.name, changes: session.opened.unsaved.value?.changes ?? 0 };
  }).value;
  const said = (): string => {
    // What was tried is in the timer only as far as it is certain what that holds.
    if (tried > 0 && standing.sure !== 'not') return bench.triedAndWaiting(tried, count);
    if (count > 0) return program.changes(count);
    if (standing.sure === 'not') return words.unknown(memory === null ? words.thisMemory : memoryName(memory));
    if (unfinished > 0) return words.unfinished(unfinished);
    if (kept) return words.ofSetting([kept.model, kept.setting].filter(Boolean).join(', '), kept.changes);
    if (editor.madeAt.value !== null) return words.made;
    if (time === null) return words.asLastRead;
    if (standing.sure === 'once') return words.lastReadAt(time);
    return standing.verified ? words.verified(time) : words.readAt(time);
  };
  const open = standing.sure === 'not';
  const differs = tried + count + unfinished > 0;
  const state = open ? 'open' : differs ? 'differs' : standing.sure === 'now' ? 'known' : 'once';
  // The same in the room that a phone has.
  const short = {
    open: strip.notCertain,
    differs: strip.shortChanges(tried + count + unfinished),
    known: strip.asInTimer,
    once: kept ? strip.ofSetting(kept.changes) : editor.madeAt.value === null ? strip.asRead : strip.made,
  }[state];
  return (
    <p class={`changes ${state}`} role="status">
      <strong class="changes-long">{said()}</strong>{' '}
      <strong class="changes-short" aria-hidden="true">
        {short}
      </strong>
      {count > 0 && <span class="visually-hidden">{words.hints[standing.sure](time)}</span>}
    </p>
  );
}
