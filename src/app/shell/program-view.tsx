import { useComputed, useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useCallback, useEffect, useLayoutEffect, useMemo } from 'preact/hooks';
import { fieldKey, fieldsOf, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { offerScreen } from '../library/share/share-screen.js';
import type { Sharing } from '../library/share/sharing.js';
import type { Memories } from '../memories/memories.js';
import { MemoryLook, MemoryPicture } from '../memories/memory-look.js';
import { messages } from '../messages/index.js';
import { timerName } from '../messages/names.js';
import { ChecksPanel } from '../program/checks-panel.js';
import { DtPresets } from '../program/presets.js';
import type { ProgramPicture } from '../program/program-picture.js';
import { ProgramTable } from '../program/program-table.js';
import { RowTools } from '../program/row-tools.js';
import { TimelinePanel } from '../program/timeline-panel.js';
import type { Preferences } from '../records/preferences.js';
import { NARROW } from '../ui/shapes.js';
import { useQuery } from '../ui/use-query.js';
import { CommandBar, type CommandBarProps } from './command-bar.js';
import './program-view.css';

export interface ProgramViewProps extends Omit<CommandBarProps, 'onShift' | 'picture' | 'onField'> {
  readonly memories: Memories;
  readonly preferences: Preferences;
  readonly programPicture: ProgramPicture;
  readonly sharing: Sharing;
  /** Logs a flight with what the timer holds. */
  readonly flying: ComponentChildren;
  readonly onPrint: () => void;
}

/** The program on the screen: the large figures, the table, the checks, and the way to the timer. */
export function ProgramView(props: ProgramViewProps) {
  const { session, write, memories, bench, follow, preferences, programPicture, saveSetting, sharing } = props;
  const { onPrint, flying } = props;
  const { program, header, about, views: words } = messages.value;
  const identity = session.editor.identity.value;
  const selected = useSignal<ProgramField | null>(null);
  const marked = useComputed(() => programPicture.timeline.pointed.value ?? selected.value);
  const select = useCallback((field: ProgramField | null) => {
    selected.value = field;
  }, []);
  // While another memory is being selected, typing would change the one that is left.
  const leaving = useComputed(() => session.runner.job.value?.kind === 'select').value;
  // Not beside the values of a memory that does not fly next.
  const canFly = useComputed(() => session.connection.value !== null && !session.onScreen.apart.value).value;
  const isWriting = useComputed(() => write.current.value !== null).value;
  const looking = memories.looking.value;
  const isNarrow = useQuery(NARROW).value;
  const picture = programPicture.isOpen.value;
  const tools = useMemo(() => new RowTools(session.editor), [session]);
  const toggle = (): void => {
    programPicture.toggle();
    // Table and picture each begin at their top.
    document.documentElement.scrollTop = 0;
  };
  // The table is seen first: what stands beside it takes as long again to draw, and comes in the next frame.
  const drawn = useSignal(false);
  useEffect(() => {
    drawn.value = true;
  }, []);
  const sought = programPicture.sought.value;
  useLayoutEffect(() => {
    if (!sought) return;
    const input = document.querySelector<HTMLInputElement>(`input[data-field="${fieldKey(sought)}"]`);
    input?.focus({ preventScroll: true });
    input?.scrollIntoView({ block: 'center' });
    programPicture.found();
  }, [sought, programPicture]);
  // A timer that is no longer connected may hold something else by now.
  const isPast = session.link.state.value.status === 'off' && session.editor.madeAt.value === null;
  if (!identity) return null;
  const side =
    isNarrow && !picture ? null : looking === null ? (
      <>
        <TimelinePanel
          session={session}
          trials={follow.trials}
          picture={programPicture}
          selected={selected}
          onSelect={select}
        />
        <div class="program-foot">
          <ProgramExits {...{ session, sharing, onPrint }} />
          <ChecksPanel editor={session.editor} />
        </div>
      </>
    ) : (
      <MemoryPicture session={session} memory={looking} />
    );
  return (
    <div class={`program ${isNarrow && picture ? 'shows-picture' : ''} ${isPast ? 'of-the-past' : ''}`}>
      <h1 class="visually-hidden">
        {about({ name: words.names.program })} {timerName(identity)} {session.simulated.value ? header.simulated : ''}
      </h1>
      <div class="program-main" onFocusCapture={(event) => select(fieldAt(event.target, identity) ?? selected.peek())}>
        {looking === null ? (
          <div class="of-memory" inert={leaving}>
            {!isNarrow && <DtPresets editor={session.editor} preferences={preferences} slot={identity.functions} />}
            <ProgramTable {...{ session, bench, follow, marked, tools }} />
            {/* A result of a write has it, too. Its place stays: DT above must not move while it is typed. */}
            {canFly && <div class="flying-place">{!isWriting && flying}</div>}
            {(identity.timerClass === 'B' || identity.timerClass === 'E') && <p class="hint">{program.absolute}</p>}
          </div>
        ) : (
          <MemoryLook session={session} memories={memories} memory={looking} />
        )}
      </div>
      {side && (
        <aside class="program-side" inert={leaving}>
          {drawn.value && side}
        </aside>
      )}
      {looking === null && (
        <CommandBar
          {...{ session, write, bench, follow, saveSetting }}
          onField={(field) => programPicture.seek(field)}
          onShift={isNarrow ? null : () => tools.showFor(selected.peek())}
          picture={isNarrow ? { open: picture, onToggle: toggle } : null}
        />
      )}
    </div>
  );
}

/** Sharing and printing the program. A program that cannot be carried is not shared. */
function ProgramExits({ session, sharing, onPrint }: Pick<ProgramViewProps, 'session' | 'sharing' | 'onPrint'>) {
  const { views } = messages.value;
  // Texts that are no value yet come and go while somebody types.
  const isSavable = useComputed(() => session.opened.savable.value).value;
  return (
    <div class="row gap-1 program-exits">
      <button type="button" class="quiet" disabled={!isSavable} onClick={() => offerScreen(session, sharing)}>
        {views.share}
      </button>
      <button type="button" class="quiet" data-print onClick={onPrint}>
        {views.print}
      </button>
    </div>
  );
}

/** The field of an element on the screen. */
function fieldAt(target: EventTarget | null, identity: Identity): ProgramField | null {
  const key = target instanceof HTMLInputElement ? target.getAttribute('data-field') : null;
  return fieldsOf(identity).find((field) => fieldKey(field) === key) ?? null;
}
