import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { Identity } from '../../protocol/index.js';
import { positionsOf, stepServo, stopsOf } from '../editing/edits.js';
import { type Parsed, parseSteps } from '../editing/units.js';
import { messages, signed, slotInSentence, slotsText } from '../messages/index.js';
import { Problem } from '../ui/problem.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import type { RowTools } from './row-tools.js';
import type { TableModel } from './table-model.js';
import { type OpenMenu, PanelFoot, ToolsMenu, ToolsPanel, useEdit } from './tools-menu.js';

export interface ServoMenuProps {
  readonly table: TableModel;
  readonly tools: RowTools;
  readonly identity: Identity;
  readonly servo: number;
  /** What it is called: its number, and what it moves. */
  readonly name: string;
}

/** The menu at the heading of a servo: all its positions by a step, as after its surface was mounted anew. */
export function ServoMenu(props: ServoMenuProps) {
  return (
    <ToolsMenu tools={props.tools} at={`servo-${props.servo}`} name={props.name}>
      {(menu) => <ServoPanel {...props} menu={menu} />}
    </ToolsMenu>
  );
}

function ServoPanel({ table, identity, servo, name, menu }: ServoMenuProps & { readonly menu: OpenMenu }) {
  const { stepServo: words } = messages.value.edits;
  const typed = useSignal('');
  const { problem, forget, edit } = useEdit(table.editor);
  const scope = useSignal<'all' | 'from'>('all');
  // As it was when the tools were opened: a digit that is typed here ends the range.
  const selected = useMemo(() => {
    const { top = 0 } = table.selection.range.peek() ?? {};
    // The cell may be of a longer program.
    return top <= identity.functions ? top : 0;
  }, [table, identity]);
  const working = table.editor.working.value;
  if (!working) return null;
  const from = scope.value === 'from' ? selected : 0;
  const parsed = parseSteps(typed.value.replace(/^\s*\+/, ''));
  const wanted = 'value' in parsed ? parsed.value : 0;
  const positions = positionsOf(working, { servo, from }).map(({ value }) => value);
  const [lowest, highest] = [Math.min(...positions), Math.max(...positions)];
  const step = (by: Parsed): void => edit(by, (steps, now) => stepServo(now, { servo, by: steps, from }));
  return (
    <ToolsPanel menu={menu} title={words.title({ servo: name })} onSubmit={() => step(parsed)}>
      <p class="hint sentence row-panel-moved" role="status">
        {lowest === highest ? words.now({ position: lowest }) : words.nowRange({ lowest, highest })}
      </p>
      <div class="shift-fields step-fields">
        {[-1, 1].map((by) => (
          <button type="button" key={by} onClick={() => step({ value: by })}>
            {signed(by)}
          </button>
        ))}
        <label>
          <span class="visually-hidden">{words.by}</span>
          <input
            type="text"
            autocomplete="off"
            value={typed.value}
            onInput={({ currentTarget }) => {
              typed.value = currentTarget.value;
              forget();
            }}
          />
        </label>
        <button type="submit">{words.step}</button>
      </div>
      <Problem text={problem} />
      {/* What would not go as far, said before it is done. */}
      {[...new Set([-1, 1, wanted])].flatMap((by) =>
        [...stopsOf(working, { servo, by, from })].map(([at, slots]) => (
          <p class="stops" key={`${by} ${at}`}>
            {words.stops({
              steps: signed(by),
              what: slotsText(identity, slots, slotInSentence(identity, 0)),
              count: slots.length,
              at,
            })}
          </p>
        )),
      )}
      {selected > 0 && (
        <SegmentChoice
          name="step-servo"
          title={words.which}
          choices={['all', 'from'] as const}
          names={{ all: words.all, from: words.from({ slot: slotInSentence(identity, selected) }) }}
          chosen={scope.value}
          onChoose={(choice) => {
            scope.value = choice;
          }}
        />
      )}
      <PanelFoot menu={menu} />
    </ToolsPanel>
  );
}
