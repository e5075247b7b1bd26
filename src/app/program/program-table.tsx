import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import type { ProgramField } from '../../program/index.js';
import { slotCount } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { fillDown } from '../editing/edits.js';
import { messages, obstacleText } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useHeight } from '../ui/use-height.js';
import { ColumnMenu } from './column-menu.js';
import { PasteDialog, type Pasting } from './paste-dialog.js';
import { ProgramRow } from './program-row.js';
import { RangeBar } from './range-bar.js';
import { useSelectRange } from './select-range.js';
import { Selection } from './selection.js';
import { cellAt } from './table-cells.js';
import { tableClipboard } from './table-clipboard.js';
import './program-table.css';

interface ProgramTableProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  /** The field whose handle is meant in the timeline: a signal, so that only its row is drawn again. */
  readonly marked: ReadonlySignal<ProgramField | null>;
}

/** Start to DT as rows; time, interval and servos as columns. It is worked with like a spreadsheet. */
export function ProgramTable({ session, bench, follow, marked }: ProgramTableProps) {
  const { editor } = session;
  const { program, edits, servoName } = messages.value;
  const selection = useMemo(() => new Selection(), []);
  const pasting = useSignal<Pasting | null>(null);
  const obstacle = useSignal<string | null>(null);
  const table = useRef<HTMLTableElement>(null);
  const foot = useRef<HTMLDivElement>(null);
  useHeight(foot, '--range');
  const identity = editor.identity.value;
  const servos = useMemo(() => Array.from({ length: identity?.servos ?? 0 }, (_, servo) => servo), [identity]);

  const say = (text: string | null): void => {
    obstacle.value = text;
  };
  /** A single cell is filled from the one above it. */
  const fill = (): void => {
    const { working } = editor;
    const range = selection.range.value;
    if (!identity || !range || !working.value) return;
    const from = range.top === range.bottom ? { ...range, top: range.top - 1 } : range;
    if (from.top < 0) return;
    const found = editor.apply(fillDown(working.value, from, { unreadable: editor.unreadable.value }));
    say(found && obstacleText(identity, found));
  };
  const { selectedText, copy, cut, paste, pasteCopied } = tableClipboard({
    editor,
    selection,
    onPaste: (text) => {
      pasting.value = text;
    },
    onObstacle: say,
  });
  const listeners = useSelectRange({
    editor,
    selection,
    fillDown: fill,
    toBar: () => foot.current?.querySelector('button')?.focus(),
    onFocus: () => say(null),
  });
  /** Whoever came to the buttons by keys goes back to the cell; a thumb does not want its keyboard. */
  const done = (): void => {
    const { value: cell } = selection.active;
    const byKeys = foot.current?.contains(document.activeElement);
    selection.collapse();
    say(null);
    if (byKeys && cell && table.current) cellAt(table.current, cell)?.querySelector('input')?.focus();
  };
  if (!identity) return null;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  return (
    <div class="table-box">
      <table
        ref={table}
        class={selection.picking.value ? 'program-table picking' : 'program-table'}
        aria-describedby="table-keys"
        {...listeners}
        onCopy={copy}
        onCut={cut}
        onPaste={paste}
      >
        <caption class="visually-hidden">{program.tableCaption}</caption>
        <thead>
          <tr>
            <th scope="col">{program.slot}</th>
            <th scope="col">{program.time}</th>
            <th scope="col">{edits.table.interval}</th>
            {servos.map((servo) => (
              <th scope="col" key={servo} aria-label={servoName(servo)}>
                {servoName(servo)}
                <ColumnMenu editor={editor} identity={identity} servo={servo} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {slots.map((slot) => (
            <ProgramRow key={slot} {...{ session, bench, follow, identity, slot, servos, selection, marked }} />
          ))}
        </tbody>
      </table>
      <p class="hint keys-hint" id="table-keys">
        {edits.table.keys}
      </p>
      <div class="range-foot" ref={foot}>
        <RangeBar
          {...{ identity, selection }}
          text={selectedText}
          onPaste={() => void pasteCopied()}
          onFill={fill}
          onDone={done}
        />
        {obstacle.value && (
          <p class="notes bad-text" role="alert">
            {edits.nothingDone} {obstacle.value}
          </p>
        )}
      </div>
      <PasteDialog
        session={session}
        pasting={pasting}
        onClose={() => {
          pasting.value = null;
        }}
      />
    </div>
  );
}
