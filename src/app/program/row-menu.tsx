import { useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { shiftFrom, slotsThatShift } from '../editing/edits.js';
import type { StepName } from '../editing/history.js';
import { formatInterval, parseInterval } from '../editing/units.js';
import { messages, slotsText } from '../messages/index.js';
import { Check } from '../ui/check.js';
import { Problem } from '../ui/problem.js';
import type { RowTools } from './row-tools.js';
import { type OpenMenu, PanelFoot, ToolsMenu, ToolsPanel, useEdit } from './tools-menu.js';

interface RowMenuProps {
  readonly tools: RowTools;
  readonly identity: Identity;
  readonly slot: number;
  /** The name of the row. */
  readonly name: string;
  /** Whether its time, and all later ones, can be shifted. */
  readonly shifts: boolean;
  /** Its values. */
  readonly fields: readonly ProgramField[];
}

/** The menu at the name of a row: edits from that row on. For the keyboard it opens left of the time. */
export function RowMenu(props: RowMenuProps) {
  const { tools, slot, name, fields, shifts } = props;
  const isWanted = useComputed(() => shifts || isChanged(tools, fields)).value;
  if (!isWanted) return null;
  // The start has no time to shift, and shares its slot with the motor stop.
  return (
    <ToolsMenu {...{ tools, name }} at={shifts ? slot : 'start'}>
      {(menu) => <RowPanel {...props} menu={menu} />}
    </ToolsMenu>
  );
}

/** Whether one of these values differs from the timer. */
function isChanged({ editor: { changed, unreadable } }: RowTools, fields: readonly ProgramField[]): boolean {
  return fields.map(fieldKey).some((key) => changed.value.has(key) || unreadable.value.has(key));
}

function RowPanel({ menu, ...props }: RowMenuProps & { readonly menu: OpenMenu }) {
  const { tools, identity, slot, name, fields, shifts } = props;
  const { editor } = tools;
  const { edits, times } = messages.value;
  const { shift } = edits;
  const { problem, forget, edit } = useEdit(editor);
  const canPutBack = useComputed(() => isChanged(tools, fields)).value;
  const isDt = slot === identity.functions;
  const move = (direction: 1 | -1): void =>
    edit(parseInterval(tools.amount.value), (by, working) =>
      shiftFrom(working, slot, direction * by, { moveDt: tools.moveDt.value }),
    );
  const putBack = (): void => {
    const [field, ...others] = fields;
    const params: StepName['params'] = field && others.length === 0 ? { field: fieldKey(field) } : { slot };
    editor.revertFields({ code: 'change', params }, fields);
    menu.close();
  };
  return (
    <ToolsPanel menu={menu} title={shifts ? shift.from({ row: name, isLast: isDt }) : name} onSubmit={() => move(1)}>
      {shifts && (
        <>
          <Moved {...{ tools, identity, slot }} />
          <div class="shift-fields">
            <button type="button" onClick={() => move(-1)}>
              {shift.earlier}
            </button>
            <label>
              <span class="visually-hidden">{shift.by}</span>
              <input
                type="text"
                inputMode="decimal"
                autocomplete="off"
                value={tools.amount.value}
                onInput={(event) => {
                  tools.setAmount(event.currentTarget.value);
                  forget();
                }}
              />
              <span aria-hidden="true">{times.units.s}</span>
            </label>
            <button type="submit">{shift.later}</button>
          </div>
          <Problem text={problem} />
        </>
      )}
      <PanelFoot menu={menu}>
        {shifts && !isDt && (
          <Check checked={tools.moveDt.value} onChange={(checked) => tools.setMoveDt(checked)}>
            {shift.moveDt}
          </Check>
        )}
        {canPutBack && (
          <button type="button" onClick={putBack}>
            {edits.field.putBack({ field: name })}
          </button>
        )}
      </PanelFoot>
    </ToolsPanel>
  );
}

/** How far everything has moved since the tools were opened; before that, what a shift would move. */
function Moved({ tools, identity, slot }: Pick<RowMenuProps, 'tools' | 'identity' | 'slot'>) {
  const { working, undoStep } = tools.editor;
  const { edits, program } = messages.value;
  const before = useMemo(() => working.peek()?.times[slot] ?? 0, [working, slot]);
  const moved = useComputed(() => {
    const { value: step } = undoStep;
    const { slot: from } = step?.params ?? {};
    return step?.code === 'shift' && from === slot ? (working.value?.times[slot] ?? 0) - before : 0;
  }).value;
  const moving = useComputed(
    () => working.value && slotsThatShift(working.value, slot, { moveDt: tools.moveDt.value }),
  ).value;
  return (
    <p class="hint sentence row-panel-moved" role="status">
      {moved === 0
        ? slotsText(identity, moving ?? [], program.motorStop)
        : edits.shift.moved({ time: formatInterval(Math.abs(moved)), later: moved > 0 })}
    </p>
  );
}
