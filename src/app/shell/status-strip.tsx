import { useComputed, useSignal } from '@preact/signals';
import { useCallback, useEffect, useId, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Follow } from '../bench/follow.js';
import { ConnectButtons } from '../connect/connect-buttons.js';
import type { SaveSetting } from '../library/save-setting.js';
import type { Leaving } from '../memories/leaving.js';
import type { Memories } from '../memories/memories.js';
import { MemoryChoice } from '../memories/memory-choice.js';
import { fieldInSentence, figureText, messages } from '../messages/index.js';
import { keyFields } from '../messages/key-figures.js';
import { memoryName, timerName } from '../messages/names.js';
import type { Preferences } from '../records/preferences.js';
import { possibleValues } from '../timer/known.js';
import type { Link } from '../timer/link.js';
import { onDemand } from '../ui/on-demand.js';
import { PlaneIcon } from '../ui/plane-icon.js';
import { NARROW, TIGHT } from '../ui/shapes.js';
import { useQuery } from '../ui/use-query.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { KnownLine } from './known-line.js';
import { SettingLine } from './setting-line.js';
import { StripModel } from './strip-model.js';
import './status-strip.css';

/** What the figures open, loaded after the first picture. */
export const figures = onDemand(() => import('./figures-panel.js'));
const FiguresPanel = figures.part((file) => file.FiguresPanel);

export interface StatusStripProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly leaving: Leaving;
  readonly follow: Follow;
  readonly preferences: Preferences;
  readonly saveSetting: SaveSetting;
  /** Whether the connecting is shown large, in place of the program. It has its own way to stop. */
  readonly staged: boolean;
  /** Goes to a field of the table. */
  readonly onField: (field: ProgramField) => void;
}

/**
 * What is true now, in every view: the timer and its memory, DT and motor stop, and how certain they are. A figure
 * leads to its field in the table. Where not all has room in one line, the memory is a button that opens the rest.
 */
export function StatusStrip(props: StatusStripProps & { readonly hash: string }) {
  const { session, memories, leaving, follow, preferences, saveSetting, staged, hash, onField } = props;
  const { name, header, strip } = messages.value;
  const { status } = session.link.state.value;
  const isNarrow = useQuery(NARROW).value;
  const isTight = useQuery(TIGHT).value;
  const open = useSignal(false);
  const panel = useId();
  const box = useRef<HTMLDivElement>(null);
  const identity = session.editor.identity.value;
  const isOpen = isTight && open.value && identity !== null;
  const close = useCallback((): void => {
    open.value = false;
    box.current?.querySelector<HTMLElement>('.strip-more')?.focus();
  }, [open]);
  useEffect(() => {
    if (!isOpen) return;
    const onKey = (event: KeyboardEvent): void => {
      if (event.key === 'Escape' && !event.defaultPrevented && !document.querySelector('dialog[open]')) close();
    };
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, [isOpen, close]);
  const kind = session.runner.job.value?.kind;
  // Another memory or view, or none: the panel gives way to what has changed. Whoever walks through the memories by
  // keys is not there yet.
  const shown = [
    memories.looking.value,
    session.onScreen.memory.value,
    kind === 'look' || kind === 'select',
    status === 'off',
    hash,
  ].join();
  const before = useRef(shown);
  useEffect(() => {
    if (before.current === shown) return;
    before.current = shown;
    if (!open.peek() || box.current?.querySelector('.memories input:focus-visible, .memories-list:focus-visible'))
      return;
    if (box.current?.querySelector('.strip-panel')?.contains(document.activeElement)) close();
    else open.value = false;
  }, [shown, isTight, open, close]);
  // Also on a tablet, where the ways to another timer are the most that the strip has to hold.
  const isFolded = identity !== null && (isNarrow || (isTight && status === 'off'));
  const actions = (
    <div class="buttons top-actions">
      {status === 'off' && identity && <ConnectButtons session={session} {...(isTight ? { part: 'rest' } : {})} />}
      {status === 'on' && !staged && (
        <button type="button" class="quiet" onClick={() => void leaving.disconnect()}>
          {header.disconnect}
        </button>
      )}
    </div>
  );
  const choice = identity && <MemoryChoice session={session} memories={memories} />;
  return (
    <div class="strip" ref={box}>
      <div class="strip-line">
        <p class="row brand">
          <img src="./favicon.svg" alt="" width="32" height="32" />
          {!identity && <span>{name}</span>}
        </p>
        {!isNarrow && <StripModel session={session} />}
        {isTight && identity && status === 'off' && !session.link.unavailable ? (
          <ConnectButtons session={session} part="first" />
        ) : (
          <LinkState
            link={session.link}
            simulated={session.simulated.value}
            model={isNarrow ? (session.origin.timer.value?.name ?? null) : null}
          />
        )}
        {!isTight && choice}
        {identity && (
          <div class="strip-figures">
            {isTight ? (
              <button
                type="button"
                class="strip-more"
                aria-expanded={isOpen}
                aria-controls={panel}
                onClick={() => (open.value = !open.value)}
              >
                <MemoryNow session={session} />
                <span class="visually-hidden">{strip.panel}</span>
              </button>
            ) : (
              memories.looking.value !== null && <MemoryNow session={session} />
            )}
            {keyFields(identity).map((field) => (
              <Figure key={fieldKey(field)} {...{ session, identity, field }} onPress={() => onField(field)} />
            ))}
          </div>
        )}
        {identity && <KnownLine session={session} follow={follow} />}
        {!isFolded && actions}
      </div>
      <SettingLine session={session} />
      {isOpen && (
        <FiguresPanel
          {...{ id: panel, session, memories, preferences, saveSetting }}
          rest={{
            choice,
            isPhone: isNarrow,
            actions: isFolded ? (
              <div class="row between">
                {isNarrow && <StripModel session={session} />}
                {actions}
              </div>
            ) : null,
          }}
          onClose={close}
        />
      )}
    </div>
  );
}

/** The memory on the screen, where there is no room to choose one. */
function MemoryNow({ session }: { readonly session: Session }) {
  const { header, nextFlight } = messages.value;
  const memory = session.onScreen.memory.value;
  const isConnected = session.connection.value !== null;
  const isSimulated = !isConnected && session.simulated.value;
  if (memory === null) return null;
  const flies = isConnected && session.nextFlight.memory.value === memory;
  return (
    <span class="strip-memory">
      {/* The state of the connection has given its place to Connect. */}
      {isSimulated && <small>{header.simulated}</small>}
      {flies ? (
        <>
          <span key={`named ${memory}`} class="visually-hidden">
            {nextFlight.named({ memory: memoryText(session, memory) })}
          </span>
          <span key={memory} aria-hidden="true">
            {memoryName(memory)}
          </span>{' '}
          <PlaneIcon />
        </>
      ) : (
        <span key={memory}>{memoryName(memory)}</span>
      )}
    </span>
  );
}

interface FigureProps {
  readonly session: Session;
  readonly identity: Identity;
  readonly field: ProgramField;
  readonly onPress: () => void;
}

/**
 * DT, or on a Q the motor stop, of the program on the screen. It is red for a short DT, when an interrupted write was
 * to change it, and while what was typed is no value: then the value before it is no longer meant.
 */
function Figure({ session, identity, field, onPress }: FigureProps) {
  const { program, strip } = messages.value;
  const { editor } = session;
  const key = fieldKey(field);
  const isValid = useComputed(() => !editor.unreadable.value.has(key)).value;
  const text = useComputed(() => {
    const value = editor.working.value && valueAt(editor.working.value, field);
    return value === null ? '' : figureText(identity, field, value);
  }).value;
  const isShort = useComputed(() => {
    const isDt = field.kind === 'time' && field.slot === identity.functions;
    return isDt && editor.findings.value.some(({ code }) => code === 'dt-short');
  }).value;
  /** Uncertain figures are red; those that were only read earlier are grey. */
  const look = useComputed(() => {
    const { sure } = session.standing.value;
    const { known } = session.standings.of(session.onScreen.memory.value);
    const isOpen = known.state === 'uncertain' && possibleValues(known, field).length > 1;
    if (isOpen) return 'bad';
    if (editor.changes.value.some(({ field: changed }) => fieldKey(changed) === key)) return 'changed';
    if (sure === 'not') return 'past';
    return sure === 'once' && editor.madeAt.value === null && !session.connection.value ? 'past' : '';
  }).value;
  const [figure, unit] = isValid ? text.split(' ') : [strip.notValid, ''];
  const name = isShort && isValid ? program.shortDt : fieldInSentence(identity, field);
  return (
    <button type="button" onClick={onPress}>
      <span key={`${name} ${figure} ${unit}`} class={`strip-figure ${isShort || !isValid ? 'bad' : look}`}>
        <small class="sentence">{name}</small> <b>{figure}</b> <small class="strip-unit">{unit}</small>
      </span>
    </button>
  );
}

interface LinkStateProps {
  readonly link: Link;
  /** Whether the program on the screen came from a simulated timer. */
  readonly simulated: boolean;
  /** The name of the model, where there is no room for it beside the class of its timer; else null. */
  readonly model: string | null;
}

function LinkState({ link, simulated, model }: LinkStateProps) {
  const { header, link: words } = messages.value;
  const state = link.state.value;
  if (state.status === 'on') {
    const { identity } = state.connection;
    return (
      <p class="row link-state on">
        <strong key={model ?? timerName(identity)}>{model ?? timerName(identity)}</strong>{' '}
        <span key={identity.firmware}>{header.firmware({ firmware: identity.firmware })}</span>
        {link.simulated.value && <span class="badge">{header.simulated}</span>}
      </p>
    );
  }
  const busy = state.status === 'off' ? '' : 'busy';
  const { choosing } = words.stages;
  const { status } = state;
  const said = status === 'choosing' ? choosing : words.status[status === 'waiting' ? 'searching' : status];
  return (
    <p key={said} class={`row link-state ${busy}`}>
      {said}
      {simulated && <span class="badge">{header.simulated}</span>}
    </p>
  );
}
