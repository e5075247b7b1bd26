import type { Identity } from '../../protocol/index.js';
import { changeText, fieldLabel, messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import { triedText } from '../write/unfinished-text.js';
import type { Bench } from './bench.js';
import { doneText, standText } from './bench-text.js';
import type { Follow } from './follow.js';
import type { Unlike } from './taken.js';
import './follow-panel.css';

interface FollowSwitchProps {
  readonly bench: Bench;
  readonly follow: Follow;
  readonly identity: Identity;
}

/** The switch, and what was tried: the band above all views asks what becomes of it. */
export function FollowSwitch({ bench, follow, identity }: FollowSwitchProps) {
  const { bench: words, program } = messages.value;
  const on = follow.on.value;
  const tried = follow.trials.tried.value;
  const open = !on && tried.length > 0;
  const isStarting = follow.starting.value;
  return (
    <section class={`stack panel ${on ? 'follows' : ''}`}>
      <button
        type="button"
        class="row gap-3 switch"
        role="switch"
        aria-checked={on}
        aria-disabled={!on && (open || isStarting || !bench.ready.value)}
        onClick={() => void (on ? follow.stop() : follow.start())}
      >
        <span class="switch-track" aria-hidden="true" />
        {words.follow}
      </button>
      <p class="hint">{on ? words.followingNow : isStarting ? program.reading : words.followHint}</p>
      {on && <p role="status">{tried.length > 0 && triedText(identity, tried)}</p>}
    </section>
  );
}

interface FollowNoteProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
}

/**
 * For places where fields are edited: shows that edits move the servos, and how following ended. The band above all
 * views asks what becomes of the positions that were tried.
 */
export function FollowNote({ session, bench, follow }: FollowNoteProps) {
  const { bench: words, dismiss } = messages.value;
  const identity = session.editor.identity.value;
  const ended = follow.ended.value;
  const done = bench.done.value;
  if (!identity) return null;
  if (follow.on.value) {
    return (
      <div class="row follows follow-note">
        <p>
          <strong>{words.followingNow}</strong> <span role="status">{standText(identity, bench.stand.at.value)}</span>
        </p>
        <button type="button" onClick={() => void follow.stop()}>
          {words.stopFollowing}
        </button>
      </div>
    );
  }
  if (!ended) return null;
  return (
    <div class="row follows follow-note" role="status">
      <p>
        <strong>{words.ended[ended.reason]}</strong> {ended.unlike && `${unlikeText(identity, ended.unlike)} `}
        {done && !done.certain && <span class="bad-text">{doneText(identity, done, null)}</span>}
      </p>
      <button type="button" class="quiet" onClick={() => follow.dismissEnd()}>
        {dismiss}
      </button>
    </div>
  );
}

/** How many changed values are named. */
const NAMED = 3;

/** What the timer holds in place of what it acknowledged, and what changed beside it. */
function unlikeText(identity: Identity, { notTaken, beside }: Unlike): string {
  const { bench: words } = messages.value;
  const named = beside.slice(0, NAMED).map((change) => changeText(identity, change));
  return [
    notTaken &&
      words.notTaken({
        field: fieldLabel(identity, notTaken.field),
        wanted: String(notTaken.from),
        held: String(notTaken.to),
      }),
    beside.length > 0 && words.beside({ named: named.join('; '), more: beside.length - named.length }),
  ]
    .filter(Boolean)
    .join(' ');
}
