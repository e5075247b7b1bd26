import { useComputed } from '@preact/signals';
import type { Follow } from '../bench/follow.js';
import { clockText, messages } from '../messages/index.js';
import { NARROW } from '../ui/shapes.js';
import { useQuery } from '../ui/use-query.js';
import type { Session } from '../work/session.js';
import { hintText, madeAs, standingText } from '../work/standing-text.js';
import './known-line.css';

/** How the program on the screen differs from the timer; or that it equals the last reading, and when that was. */
export function KnownLine({ session, follow }: { readonly session: Session; readonly follow: Follow }) {
  const { strip } = messages.value;
  const { editor } = session;
  const isNarrow = useQuery(NARROW).value;
  const count = useComputed(() => editor.changes.value.length).value;
  const unfinished = useComputed(() => editor.unreadable.value.size).value;
  const tried = useComputed(() => follow.trials.tried.value.length).value;
  const memory = session.onScreen.memory.value;
  const standing = session.standing.value;
  const made = useComputed(() => madeAs(session)).value;
  const open = standing.sure === 'not';
  const differs = tried + count + unfinished > 0;
  const state = open ? 'open' : differs ? 'differs' : standing.sure === 'now' ? 'known' : 'once';
  const isTried = state === 'differs' && tried > 0 && count === 0;
  // The same, for the room on a phone.
  const short = {
    open: strip.notCertain,
    differs: isTried ? strip.tried({ count: tried }) : String(tried + count || unfinished),
    known: '✓',
    once: made === null ? strip.asRead : made === 'new' ? strip.made : strip.ofSetting({ changes: made.changes }),
  }[state];
  const long = standingText(standing, { tried, changes: count, unfinished }, made, memory, clockText);
  const hint = count > 0 ? hintText(standing, clockText) : null;
  // Keyed by their words, here and in the whole strip: new words are a new element. What a translator or an extension
  // has put in place of the old text goes with it, and cannot stay as if it were still true.
  return (
    <p class={`changes ${state} ${isTried ? 'tried' : ''}`} role="status">
      <strong key={`long ${long}`} class={isNarrow ? 'visually-hidden' : ''}>
        {long}
      </strong>{' '}
      {isNarrow && (
        <strong key={`short ${short}`} class="changes-short" aria-hidden="true">
          {short}
        </strong>
      )}
      {hint && (
        <span key={hint} class="visually-hidden">
          {hint}
        </span>
      )}
    </p>
  );
}
