import { useComputed } from '@preact/signals';
import type { Follow } from '../bench/follow.js';
import { clockText, messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useLateComputed } from '../ui/use-late.js';
import './known-line.css';

/** How the program on the screen differs from the timer; or that it equals the last reading, and when that was. */
export function KnownLine({ session, follow }: { readonly session: Session; readonly follow: Follow }) {
  const { program, bench, knowledge: words, memoryName, strip } = messages.value;
  const { editor } = session;
  const of = useComputed(() => [editor.baseline.value, session.standing.value]);
  // After the field that was typed into. All of these come in the same frame: one sentence uses them together.
  const count = useLateComputed(() => editor.changes.value.length, of);
  const unfinished = useLateComputed(() => editor.unreadable.value.size, of);
  const tried = useLateComputed(() => follow.trials.tried.value.length, of);
  const memory = useComputed(() => editor.working.value?.memory ?? null).value;
  const standing = session.standing.value;
  const time = standing.at === null ? null : clockText(standing.at);
  // A program that is of no timer, but of the library.
  const kept = useLateComputed(() => {
    const opened = editor.madeAt.value === null ? null : session.opened.shown.value;
    if (!opened?.setting) return null;
    const { model, setting } = opened;
    return { model: model?.name, setting: setting.name, changes: session.opened.unsaved.value?.changes ?? 0 };
  }, of);
  const said = (): string => {
    // Tried positions count as in the timer only while its content is certain.
    if (tried > 0 && standing.sure !== 'not') return bench.triedAndWaiting(tried, count);
    // What it would be changed from is not known.
    if (standing.sure === 'not') return words.unknown(memory === null ? words.thisMemory : memoryName(memory));
    if (count > 0) return program.changes(count);
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
  const isTried = state === 'differs' && tried > 0 && count === 0;
  // The same, for the room on a phone.
  const short = {
    open: strip.notCertain,
    differs: isTried ? strip.tried(tried) : strip.shortChanges(tried + count || unfinished),
    known: strip.asInTimer,
    once: kept ? strip.ofSetting(kept.changes) : editor.madeAt.value === null ? strip.asRead : strip.made,
  }[state];
  const long = said();
  const hint = count > 0 ? words.hints[standing.sure](time) : null;
  // Keyed by their words, here and in the whole strip: new words are a new element. What a translator or an extension
  // has put in place of the old text goes with it, and cannot stay as if it were still true.
  return (
    <p class={`changes ${state} ${isTried ? 'tried' : ''}`} role="status">
      <strong key={`long ${long}`} class="changes-long">
        {long}
      </strong>{' '}
      <strong key={`short ${short}`} class="changes-short" aria-hidden="true">
        {short}
      </strong>
      {hint && (
        <span key={hint} class="visually-hidden">
          {hint}
        </span>
      )}
    </p>
  );
}
