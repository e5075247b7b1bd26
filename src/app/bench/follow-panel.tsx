import type { ComponentChildren } from 'preact';
import { fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { changeText, fieldLabel, messages, slotInSentence } from '../messages/index.js';
import type { Session } from '../session/session.js';
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

/** The switch, and what to do with the positions that were tried. */
export function FollowSwitch({ bench, follow, identity }: FollowSwitchProps) {
  const { bench: words } = messages.value;
  const on = follow.on.value;
  const tried = follow.trials.tried.value;
  const open = !on && tried.length > 0;
  const isStarting = follow.starting.value;
  return (
    <section class={`bench-follow ${on ? 'on' : ''}`}>
      <Switch
        on={on}
        disabled={!on && (open || isStarting || !bench.ready.value)}
        onClick={() => void (on ? follow.stop() : follow.start())}
      >
        {words.follow}
      </Switch>
      <p class="hint">{on ? words.followingNow : isStarting ? words.starting : words.followHint}</p>
      {follow.unkept.value && (
        <div role="alert">
          <p class="bad-text">{words.unkept}</p>
          <div class="buttons">
            <button type="button" onClick={() => follow.startUnkept()}>
              {words.followUnkept}
            </button>
            <button type="button" onClick={() => follow.cancelUnkept()}>
              {messages.value.cancel}
            </button>
          </div>
        </div>
      )}
      {on && follow.hasEarlier.value && <p class="hint">{words.followPending}</p>}
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

interface SwitchProps {
  readonly on: boolean;
  readonly disabled?: boolean;
  readonly onClick: () => void;
  readonly children: ComponentChildren;
}

function Switch({ on, disabled = false, onClick, children }: SwitchProps) {
  return (
    <button type="button" class="switch" role="switch" aria-checked={on} aria-disabled={disabled} onClick={onClick}>
      <span class="switch-track" aria-hidden="true" />
      {children}
    </button>
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
  const { bench: words } = messages.value;
  const identity = session.editor.identity.value;
  if (!identity) return null;
  if (follow.on.value) {
    const at = bench.stand.at.value;
    const isTimeWaiting = session.editor.changes.value.some(({ field }) => field.kind === 'time');
    return (
      <div class="follow-note">
        <p>
          <strong>{at === null ? words.followingNow : words.followingAt(slotInSentence(identity, at))}</strong>{' '}
          <span role="status" class={at === null ? '' : 'visually-hidden'}>
            {standText(identity, at)}
          </span>{' '}
          {isTimeWaiting && words.timesWait}
        </p>
        <button type="button" onClick={() => void follow.stop()}>
          {words.stopFollowing}
        </button>
      </div>
    );
  }
  return <EndNote bench={bench} follow={follow} identity={identity} />;
}

interface EndNoteProps {
  readonly bench: Bench;
  readonly follow: Follow;
  readonly identity: Identity;
}

/** Why the servos no longer follow, and what is known since then. */
function EndNote({ bench, follow, identity }: EndNoteProps) {
  const { bench: words, dismiss } = messages.value;
  const ended = follow.ended.value;
  const done = bench.done.value;
  if (!ended) return null;
  return (
    <div class="follow-note" role="status">
      <p>
        <strong>{words.ended[ended.reason]}</strong> {ended.unlike && `${unlikeText(identity, ended.unlike)} `}
        {follow.endRead.value ? words.endRead : words.endUnread}{' '}
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
    notTaken && words.notTaken(fieldLabel(identity, notTaken.field), String(notTaken.from), String(notTaken.to)),
    beside.length > 0 && words.beside(named, beside.length - named.length),
  ]
    .filter(Boolean)
    .join(' ');
}
