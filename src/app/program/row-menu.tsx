import { useComputed } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Identity } from '../../protocol/index.js';
import { media } from '../browser/doors.js';
import { formatInterval } from '../editing/units.js';
import { messages } from '../messages/index.js';
import { type RowTools, SHIFTS } from './row-tools.js';
import './row-menu.css';

interface RowMenuProps {
  readonly tools: RowTools;
  readonly identity: Identity;
  readonly slot: number;
  /** What the row is called. */
  readonly name: string;
  /** Whether its time, and those after it, can be shifted. */
  readonly shifts: boolean;
  /** Puts the row back to what the timer holds; null where nothing differs. */
  readonly revert: { readonly label: string; readonly act: () => void } | null;
}

/** At the name of a row: what can be done from there on. Left of the time for the keys, the whole name for a finger. */
export function RowMenu({ tools, identity, slot, name, shifts, revert }: RowMenuProps) {
  const { table } = messages.value.edits;
  const opener = useRef<HTMLButtonElement>(null);
  // The start has no time that could be shifted, and shares its slot with the motor stop.
  const at = shifts ? slot : 'start';
  const isOpen = useComputed(() => tools.open.value === at).value && (shifts || revert !== null);
  if (!shifts && !revert) return null;
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
        class="row-opener"
        tabIndex={-1}
        aria-label={table.rowTools(name)}
        title={table.rowTools(name)}
        aria-expanded={isOpen}
        onClick={() => (isOpen ? close() : tools.show(at))}
      />
      {isOpen && <RowPanel {...{ tools, identity, slot, name, shifts, revert, opener }} onClose={close} />}
    </span>
  );
}

interface RowPanelProps extends RowMenuProps {
  readonly opener: { readonly current: HTMLElement | null };
  readonly onClose: () => void;
}

function RowPanel({ tools, identity, slot, name, shifts, revert, onClose, opener }: RowPanelProps) {
  const { table, shift } = messages.value.edits;
  const panel = useRef<HTMLFormElement>(null);
  useEffect(() => {
    const { current } = panel;
    if (!current) return;
    // In the lower half there is more room above.
    const { top = 0 } = opener.current?.getBoundingClientRect() ?? {};
    current.classList.toggle('above', top > innerHeight / 2);
    current.scrollIntoView?.({ block: 'nearest' });
    // On a touch screen a field with the focus would bring up a keyboard, which nobody has asked for.
    const byTouch = media('(pointer: coarse)')?.matches ?? false;
    const first = byTouch ? null : current.querySelector('input');
    first?.select();
    (first ?? current.querySelector('button'))?.focus({ preventScroll: true });
    const away = ({ target }: Event): void => {
      if (target instanceof Node && !current.parentElement?.contains(target)) tools.close();
    };
    document.addEventListener('pointerdown', away);
    return () => document.removeEventListener('pointerdown', away);
  }, [tools, opener]);
  const isDt = slot === identity.functions;
  return (
    <form
      ref={panel}
      class="row-panel"
      aria-label={shifts ? shift.from(name, isDt) : name}
      onSubmit={(event) => {
        event.preventDefault();
        tools.shift(1);
      }}
    >
      <p class="row-panel-title">{shifts ? shift.from(name, isDt) : name}</p>
      {shifts && <Moved tools={tools} />}
      {shifts && <ShiftFields tools={tools} />}
      <div class="row-panel-foot">
        {shifts && !isDt && (
          <label class="check">
            <input
              type="checkbox"
              checked={tools.moveDt.value}
              onChange={(event) => tools.setMoveDt(event.currentTarget.checked)}
            />
            {shift.moveDt}
          </label>
        )}
        {revert && (
          <button
            type="button"
            onClick={() => {
              revert.act();
              onClose();
            }}
          >
            {revert.label}
          </button>
        )}
        <button type="button" class="quiet" onClick={onClose}>
          {table.range.done}
        </button>
      </div>
    </form>
  );
}

/** This row and all that come after it, to earlier or later. */
function ShiftFields({ tools }: { readonly tools: RowTools }) {
  const { shift } = messages.value.edits;
  const { value: problem } = tools.problem;
  return (
    <>
      <div class="shift-fields">
        {[-1, 1].map((way) =>
          SHIFTS.map((by) => (
            <button key={way * by} type="button" onClick={() => tools.shiftBy(way * by)}>
              {shift.step(by / 100, way > 0)}
            </button>
          )),
        )}
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
        <button type="button" onClick={() => tools.shift(-1)}>
          {shift.earlier}
        </button>
        <button type="submit">{shift.later}</button>
      </div>
      {problem && (
        <p class="bad-text" role="alert">
          {problem}
        </p>
      )}
    </>
  );
}

/** How far all has gone since the tools were opened. */
function Moved({ tools }: { readonly tools: RowTools }) {
  const { value: moved } = tools.moved;
  return (
    <p class="hint row-panel-moved" role="status">
      {moved !== 0 && messages.value.edits.shift.moved(formatInterval(Math.abs(moved)), moved > 0)}
    </p>
  );
}
