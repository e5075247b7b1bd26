import { useComputed, useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { TimerProgram } from '../../program/index.js';
import { onBackKey } from '../browser/back-key.js';
import { media } from '../browser/doors.js';
import type { Edit } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import type { Parsed } from '../editing/units.js';
import { messages, obstacleText } from '../messages/index.js';
import type { RowTools, ToolsPlace } from './row-tools.js';
import { raise } from './sheet-place.js';
import './tools-menu.css';

/** An open menu, for its panel. */
export interface OpenMenu {
  readonly tools: RowTools;
  readonly opener: { readonly current: HTMLElement | null };
  /** Puts the tools away, and the focus where they came from. */
  readonly close: () => void;
}

interface ToolsMenuProps {
  readonly tools: RowTools;
  readonly at: ToolsPlace;
  /** The name of the row or servo. */
  readonly name: string;
  /** A {@link ToolsPanel}. */
  readonly children: (menu: OpenMenu) => ComponentChildren;
}

/** A menu at a heading of the table, which opens from all of it. */
export function ToolsMenu({ tools, at, name, children }: ToolsMenuProps) {
  const { table } = messages.value.edits;
  const opener = useRef<HTMLButtonElement>(null);
  const isOpen = useComputed(() => tools.open.value === at).value;
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
        aria-label={table.tools({ name })}
        title={table.tools({ name })}
        aria-expanded={isOpen}
        onClick={() => (isOpen ? close() : tools.show(at))}
      />
      {isOpen && children({ tools, opener, close })}
    </span>
  );
}

interface ToolsPanelProps {
  readonly menu: OpenMenu;
  /** What the tools act on. */
  readonly title: string;
  readonly onSubmit: () => void;
  readonly children: ComponentChildren;
}

/** The tools: beside the column of their heading, or at the lower edge of a narrow window. */
export function ToolsPanel({ menu: { tools, opener }, title, onSubmit, children }: ToolsPanelProps) {
  const panel = useRef<HTMLFormElement>(null);
  useEffect(() => {
    const { current } = panel;
    const row = opener.current?.closest('tr');
    if (!current) return;
    let lower: (() => void) | null = null;
    // Where the table is narrow it would cover the values that it moves, so it lies at the lower edge.
    const place = (): void => {
      if (row && !lower && getComputedStyle(current).position === 'fixed') lower = raise(current, row);
    };
    place();
    addEventListener('resize', place);
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
      removeEventListener('resize', place);
      lower?.();
    };
  }, [tools, opener]);
  useEffect(() => onBackKey(() => tools.close()), [tools]);
  return (
    <form
      ref={panel}
      class="stack row-panel"
      aria-label={title}
      onSubmit={(event) => {
        event.preventDefault();
        onSubmit();
      }}
    >
      <p class="row-panel-title">{title}</p>
      {children}
    </form>
  );
}

/** Edits by a typed amount, and why the last one was not done. */
export function useEdit(editor: Editor) {
  const problem = useSignal<(() => string) | null>(null);
  return {
    problem: problem.value?.() ?? null,
    forget: (): void => {
      problem.value = null;
    },
    edit: (typed: Parsed, make: (by: number, working: TimerProgram) => Edit): void => {
      const { value: working } = editor.working;
      if (!working) return;
      const obstacle = 'value' in typed ? editor.apply(make(typed.value, working)) : null;
      problem.value =
        'unreadable' in typed
          ? () => messages.value.unreadable[typed.unreadable]
          : obstacle && (() => `${messages.value.edits.nothingDone} ${obstacleText(working.identity, obstacle)}`);
    },
  };
}

interface PanelFootProps {
  readonly menu: OpenMenu;
  readonly children?: ComponentChildren;
}

/** The last line of the tools, which ends with Done. */
export function PanelFoot({ menu, children }: PanelFootProps) {
  return (
    <div class="row row-panel-foot">
      {children}
      <button type="button" class="quiet" onClick={menu.close}>
        {messages.value.done}
      </button>
    </div>
  );
}
