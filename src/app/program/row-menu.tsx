import { type ReadonlySignal, useComputed } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { onBackKey } from '../browser/back-key.js';
import { media } from '../browser/doors.js';
import { formatInterval } from '../editing/units.js';
import { messages } from '../messages/index.js';
import { Check } from '../ui/check.js';
import { Problem } from '../ui/problem.js';
import type { RowTools } from './row-tools.js';
import { raise } from './sheet-place.js';
import './row-menu.css';

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

/**
 * The menu at the name of a row: edits from that row on. For the keyboard it opens left of the time; for a finger, from
 * the whole name.
 */
export function RowMenu(props: RowMenuProps) {
  const { tools, slot, name, fields, shifts } = props;
  const { table } = messages.value.edits;
  const opener = useRef<HTMLButtonElement>(null);
  // The start has no time to shift, and shares its slot with the motor stop.
  const at = shifts ? slot : 'start';
  const isChanged = useComputed(() => tools.isChanged(fields));
  const isWanted = shifts || isChanged.value;
  const isOpen = useComputed(() => tools.open.value === at).value && isWanted;
  if (!isWanted) return null;
  const close = (): void => {
    tools.close();
    opener.current?.focus();
  };
  return (
    <span
      class="row-menu"
      role="toolbar"
      onKeyDown={(event) => {
        if (event.key !== 'Escape' || !isOpen) return;
        event.stopPropagation();
        event.preventDefault();
        close();
      }}
      onFocusOut={({ relatedTarget, currentTarget }) => {
        if (relatedTarget instanceof Node && !currentTarget.contains(relatedTarget)) tools.close();
      }}
    >
      <button
        ref={opener}
        type="button"
        class="cell-cover row-opener"
        tabIndex={-1}
        aria-label={table.rowTools(name)}
        title={table.rowTools(name)}
        aria-expanded={isOpen}
        onClick={() => (isOpen ? close() : tools.show(at))}
      />
      {isOpen && <RowPanel {...props} {...{ isChanged, opener }} onClose={close} />}
    </span>
  );
}

interface RowPanelProps extends RowMenuProps {
  readonly isChanged: ReadonlySignal<boolean>;
  readonly opener: { readonly current: HTMLElement | null };
  readonly onClose: () => void;
}

function RowPanel({ tools, identity, slot, name, fields, shifts, isChanged, opener, onClose }: RowPanelProps) {
  const { edits, done } = messages.value;
  const { shift } = edits;
  const panel = useRef<HTMLFormElement>(null);
  useEffect(() => {
    const { current } = panel;
    const row = opener.current?.closest('tr');
    if (!current) return;
    // Where the table is narrow it would cover the times that it moves, so it lies at the lower edge.
    const lower = row && getComputedStyle(current).position === 'fixed' ? raise(current, row) : null;
    if (!lower) {
      // In the lower half of the window there is more room above.
      const { top = 0 } = opener.current?.getBoundingClientRect() ?? {};
      current.classList.toggle('above', top > innerHeight / 2);
      current.scrollIntoView?.({ block: 'nearest' });
    }
    // On a touch screen a focused field would open the keyboard, which nobody has asked for.
    const byTouch = media('(pointer: coarse)')?.matches ?? false;
    const first = byTouch ? null : current.querySelector('input');
    first?.select();
    (first ?? current.querySelector('button'))?.focus({ preventScroll: true });
    const away = ({ target }: Event): void => {
      if (target instanceof Node && !current.parentElement?.contains(target)) tools.close();
    };
    document.addEventListener('pointerdown', away);
    return () => {
      document.removeEventListener('pointerdown', away);
      lower?.();
    };
  }, [tools, opener]);
  useEffect(() => onBackKey(() => tools.close()), [tools]);
  const isDt = slot === identity.functions;
  return (
    <form
      ref={panel}
      class="stack row-panel"
      aria-label={shifts ? shift.from(name, isDt) : name}
      onSubmit={(event) => {
        event.preventDefault();
        tools.shift(1);
      }}
    >
      <p class="row-panel-title">{shifts ? shift.from(name, isDt) : name}</p>
      {shifts && <Moved tools={tools} identity={identity} />}
      {shifts && <ShiftFields tools={tools} />}
      <div class="row row-panel-foot">
        {shifts && !isDt && (
          <Check checked={tools.moveDt.value} onChange={(checked) => tools.setMoveDt(checked)}>
            {shift.moveDt}
          </Check>
        )}
        {isChanged.value && (
          <button
            type="button"
            onClick={() => {
              tools.putBack(slot, fields);
              onClose();
            }}
          >
            {edits.field.putBack(name)}
          </button>
        )}
        <button type="button" class="quiet" onClick={onClose}>
          {done}
        </button>
      </div>
    </form>
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
  const { shift } = messages.value.edits;
  return (
    <p class="hint row-panel-moved" role="status">
      {moved === 0 ? movingText(identity, tools.moving.value) : shift.moved(formatInterval(Math.abs(moved)), moved > 0)}
    </p>
  );
}

/** “Motor stop, functions 5 to 9, DT”. */
function movingText({ functions }: Identity, slots: readonly number[]): string {
  const { program, edits } = messages.value;
  const between = slots.filter((slot) => slot > 0 && slot < functions);
  return [
    slots.includes(0) && program.motorStop,
    between.length > 0 && edits.shift.functions(between),
    slots.includes(functions) && program.dt,
  ]
    .filter(Boolean)
    .join(', ');
}
