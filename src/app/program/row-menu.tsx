import { useComputed } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { formatInterval } from '../editing/units.js';
import { messages, slotsText } from '../messages/index.js';
import { Check } from '../ui/check.js';
import { Problem } from '../ui/problem.js';
import type { RowTools } from './row-tools.js';
import { type OpenMenu, PanelFoot, ToolsMenu, ToolsPanel } from './tools-menu.js';

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
  const isWanted = useComputed(() => shifts || tools.isChanged(fields)).value;
  if (!isWanted) return null;
  // The start has no time to shift, and shares its slot with the motor stop.
  return (
    <ToolsMenu {...{ tools, name }} at={shifts ? slot : 'start'}>
      {(menu) => <RowPanel {...props} menu={menu} />}
    </ToolsMenu>
  );
}

function RowPanel({ menu, ...props }: RowMenuProps & { readonly menu: OpenMenu }) {
  const { tools, identity, slot, name, fields, shifts } = props;
  const { edits } = messages.value;
  const { shift } = edits;
  const isChanged = useComputed(() => tools.isChanged(fields)).value;
  const isDt = slot === identity.functions;
  return (
    <ToolsPanel
      menu={menu}
      title={shifts ? shift.from({ row: name, isLast: isDt }) : name}
      onSubmit={() => tools.shift(1)}
    >
      {shifts && <Moved tools={tools} identity={identity} />}
      {shifts && <ShiftFields tools={tools} />}
      <PanelFoot menu={menu}>
        {shifts && !isDt && (
          <Check checked={tools.moveDt.value} onChange={(checked) => tools.setMoveDt(checked)}>
            {shift.moveDt}
          </Check>
        )}
        {isChanged && (
          <button
            type="button"
            onClick={() => {
              tools.putBack(slot, fields);
              menu.close();
            }}
          >
            {edits.field.putBack({ field: name })}
          </button>
        )}
      </PanelFoot>
    </ToolsPanel>
  );
}

/** Shifts this row and all later ones, to earlier or later. */
function ShiftFields({ tools }: { readonly tools: RowTools }) {
  const { shift } = messages.value.edits;
  const { value: problem } = tools.problem;
  return (
    <>
      <div class="shift-fields">
        <button type="button" onClick={() => tools.shift(-1)}>
          {shift.earlier}
        </button>
        <label>
          <span class="visually-hidden">{shift.by}</span>
          <input
            type="text"
            inputMode="decimal"
            autocomplete="off"
            value={tools.amount.value}
            onInput={(event) => tools.setAmount(event.currentTarget.value)}
          />
          <span aria-hidden="true">{messages.value.times.units.s}</span>
        </label>
        <button type="submit">{shift.later}</button>
      </div>
      <Problem text={problem} />
    </>
  );
}

/** How far everything has moved since the tools were opened; before that, what a shift would move. */
function Moved({ tools, identity }: Pick<RowMenuProps, 'tools' | 'identity'>) {
  const { value: moved } = tools.moved;
  const { edits, program } = messages.value;
  return (
    <p class="hint sentence row-panel-moved" role="status">
      {moved === 0
        ? slotsText(identity, tools.moving.value, program.motorStop)
        : edits.shift.moved({ time: formatInterval(Math.abs(moved)), later: moved > 0 })}
    </p>
  );
}
