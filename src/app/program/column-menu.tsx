import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { type Identity, slotCount } from '../../protocol/index.js';
import { onBackKey } from '../browser/back-key.js';
import type { Edit } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { copyServo, reverseServo } from '../editing/edits.js';
import { messages, obstacleText } from '../messages/index.js';
import './column-menu.css';

interface ColumnMenuProps {
  readonly editor: Editor;
  readonly identity: Identity;
  readonly servo: number;
}

/** Edits of all positions of a servo at once. */
export function ColumnMenu({ editor, identity, servo }: ColumnMenuProps) {
  const { edits, servoName } = messages.value;
  const open = useSignal(false);
  const problem = useSignal<string | null>(null);
  const opener = useRef<HTMLButtonElement>(null);
  const others = Array.from({ length: identity.servos }, (_, at) => at).filter((at) => at !== servo);

  const close = (): void => {
    open.value = false;
    problem.value = null;
    opener.current?.focus();
  };
  const isOpen = open.value;
  useEffect(() => (isOpen ? onBackKey(close) : undefined), [isOpen]);
  const apply = (edit: (program: TimerProgram) => Edit): void => {
    const { value } = editor.working;
    const obstacle = value && editor.apply(edit(value));
    if (obstacle) problem.value = `${edits.nothingDone} ${obstacleText(identity, obstacle)}`;
    else close();
  };
  const fields = Array.from(
    { length: slotCount(identity) },
    (_, slot): ProgramField => ({ kind: 'position', servo, slot }),
  );
  // While it is closed, a change of a value must not draw it.
  const isChanged =
    isOpen && fields.map(fieldKey).some((key) => editor.changed.value.has(key) || editor.unreadable.value.has(key));
  const revert = (): void => {
    editor.revertFields({ code: 'revert-column', params: { name: servoName(servo) } }, fields);
    close();
  };
  return (
    <span
      role="toolbar"
      onKeyDown={(event) => {
        if (event.key !== 'Escape' || !open.value) return;
        event.stopPropagation();
        close();
      }}
      onFocusOut={(event) => {
        if (event.relatedTarget instanceof Node && event.currentTarget.contains(event.relatedTarget)) return;
        open.value = false;
        problem.value = null;
      }}
    >
      <button
        ref={opener}
        type="button"
        class="menu-opener"
        aria-label={edits.table.tools(servoName(servo))}
        title={edits.table.tools(servoName(servo))}
        aria-expanded={isOpen}
        onClick={() => (open.value = !open.value)}
      />
      {isOpen && (
        <span class="menu">
          {others.map((to) => (
            <button type="button" key={to} onClick={() => apply((program) => copyServo(program, servo, to))}>
              {edits.table.copyTo(servoName(to))}
            </button>
          ))}
          <button type="button" onClick={() => apply((program) => reverseServo(program, servo))}>
            {edits.table.reverse}
          </button>
          {isChanged && (
            <button type="button" onClick={revert}>
              {edits.table.revertColumn}
            </button>
          )}
          {problem.value && (
            <span class="bad-text" role="alert">
              {problem.value}
            </span>
          )}
        </span>
      )}
    </span>
  );
}
