import { useComputed, useSignal } from '@preact/signals';
import { useCallback, useRef } from 'preact/hooks';
import { fieldKey, fieldsOf, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { messages, timerName } from '../messages/index.js';
import { useModels } from '../models.js';
import { AboutTimer } from '../parts/about-timer.js';
import { BenchPanel } from '../parts/bench-panel.js';
import { ChecksPanel } from '../parts/checks-panel.js';
import { FollowNote } from '../parts/follow-panel.js';
import { KnownLine } from '../parts/known-line.js';
import { MemoriesOverview } from '../parts/memories-overview.js';
import { BackupsPanel, MemoriesPanel } from '../parts/memories-panel.js';
import { MemoryChoice } from '../parts/memory-choice.js';
import { MemoryLook, MemoryPicture } from '../parts/memory-look.js';
import { DtPresets } from '../parts/presets.js';
import { ProgramTable } from '../parts/program-table.js';
import { ShiftTool } from '../parts/shift-tool.js';
import { TimelinePanel } from '../parts/timeline-panel.js';
import { UndoButtons } from '../parts/undo-buttons.js';
import { useHeight } from '../parts/use-height.js';
import { ValueField } from '../parts/value-field.js';
import { BlockedNote, WriteButton } from '../parts/write-button.js';

/** What the timer holds and what it shall hold: the large figures, the table, the checks, and the way to the timer. */
export function ProgramScreen() {
  const { session, memories, follow } = useModels();
  const { program, header, about } = messages.value;
  const identity = session.editor.identity.value;
  const selected = useSignal<ProgramField | null>(null);
  const pointed = useSignal<ProgramField | null>(null);
  const marked = useComputed(() => pointed.value ?? selected.value);
  const select = useCallback((field: ProgramField | null) => {
    selected.value = field;
  }, []);
  const point = useCallback((field: ProgramField | null) => {
    pointed.value = field;
  }, []);
  // What is typed while another memory is asked for would go into the one that is left.
  const leaving = useComputed(() => session.job.value?.kind === 'select').value;
  const looking = memories.looking.value;
  if (!identity) return null;
  return (
    <div class="program">
      <h1 class="visually-hidden">
        {about(program.title)} {timerName(identity)} {session.simulated.value ? header.simulated : ''}
      </h1>
      <div class="program-main" onFocusCapture={(event) => select(fieldAt(event.target, identity) ?? selected.peek())}>
        <MemoryChoice />
        {looking === null ? (
          <div class="of-memory" inert={leaving}>
            <LargeFigures />
            <DtPresets column={identity.functions} />
            {(identity.timerClass === 'B' || identity.timerClass === 'E') && <p class="hint">{program.absolute}</p>}
            <ProgramTable marked={marked} />
            <ShiftTool />
          </div>
        ) : (
          <MemoryLook memory={looking} />
        )}
        {/* It moves the servos to the functions of the current memory. */}
        {(looking === null || follow.on.value) && <BenchPanel />}
        <MemoriesPanel />
        <MemoriesOverview />
        <BackupsPanel />
        <AboutTimer />
      </div>
      <aside class="program-side" inert={leaving}>
        {looking === null ? (
          <>
            <TimelinePanel selected={selected.value} onSelect={select} onPoint={point} />
            <ChecksPanel />
          </>
        ) : (
          <MemoryPicture memory={looking} />
        )}
      </aside>
      {looking === null && <Actions />}
    </div>
  );
}

/** The field that a place on the screen is for. */
function fieldAt(target: EventTarget | null, identity: Identity): ProgramField | null {
  const key = target instanceof HTMLInputElement ? target.getAttribute('data-field') : null;
  return fieldsOf(identity).find((field) => fieldKey(field) === key) ?? null;
}

/** DT is always in sight; on Q the motor stop beside it. */
function LargeFigures() {
  const { session } = useModels();
  const { program } = messages.value;
  const { editor } = session;
  const identity = editor.identity.value;
  const isShort = editor.findings.value.some(({ code }) => code === 'dt-short');
  const hasThrottle = useComputed(() => typeof editor.working.value?.idleThrottle === 'number').value;
  if (!identity) return null;
  return (
    <div class="figures">
      <div class="figure">
        <span class="figure-name">
          {program.dt} {isShort && <strong class="badge loud">{program.shortDt}</strong>}
        </span>
        <ValueField field={{ kind: 'time', column: identity.functions }} label={program.dt} place="large" />
      </div>
      {identity.timerClass === 'Q' && (
        <div class="figure">
          <span class="figure-name">{program.motorStop}</span>
          <ValueField field={{ kind: 'time', column: 0 }} label={program.motorStop} place="large" />
        </div>
      )}
      {hasThrottle && (
        <div class="figure minor">
          <span class="figure-name">
            {program.idleThrottle} <span class="hint">{program.idleThrottleUnit}</span>
          </span>
          <ValueField field={{ kind: 'idleThrottle' }} label={program.idleThrottle} place="large" notesShown />
        </div>
      )}
    </div>
  );
}

function Actions() {
  const { session } = useModels();
  const { program } = messages.value;
  const { editor } = session;
  const connected = session.connection.value !== null;
  const bar = useRef<HTMLElement>(null);
  useHeight(bar, '--actions');
  return (
    <section class="actions" ref={bar}>
      <KnownLine />
      {session.link.state.value.status === 'off' && !session.link.unavailable && (
        <p class="hint">{program.notConnected}</p>
      )}
      <FollowNote />
      <BlockedNote />
      <UndoButtons />
      <div class="buttons">
        <WriteButton />
        <button
          type="button"
          aria-disabled={session.busy.value}
          disabled={!connected}
          onClick={() => void session.read()}
        >
          {program.read}
        </button>
        {editor.dirty.value && (
          <button type="button" class="quiet" disabled={session.busy.value} onClick={() => editor.revertAll()}>
            {program.undoAll}
          </button>
        )}
      </div>
    </section>
  );
}
