import { useComputed } from '@preact/signals';
import { fieldKey } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { fieldLabel, messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from '../write/write-flow.js';
import { firstInTheWay } from './field-notes.js';

const NOTE = 'blocked-note';

interface WriteButtonProps {
  readonly session: Session;
  readonly write: WriteFlow;
  /** Where there is little room. */
  readonly brief?: boolean;
}

/**
 * To the difference, and from there to the timer; where none is connected, by way of Connect. Where a field is in the
 * way it leads to that field.
 */
export function WriteButton({ session, write, brief = false }: WriteButtonProps) {
  const { editor } = session;
  const isBlocked = editor.blocked.value;
  const count = useComputed(() => editor.changes.value.length).value;
  const isConnected = session.connection.value !== null;
  const isOff = session.link.state.value.status === 'off';
  const { program } = messages.value;
  const press = async (): Promise<void> => {
    const cause = isBlocked ? firstInTheWay(editor) : null;
    if (cause) return lookAt(fieldKey(cause.field));
    if (!isConnected) await session.timer.comeBack();
    // The timer may have to be waited for: by then the pilot may have something else in mind.
    if (session.runner.ready.value) void write.open();
  };
  return (
    <button
      type="button"
      class={isBlocked ? 'blocked' : count > 0 ? 'primary' : ''}
      // Not while a job runs; but the focus stays, also for when the dialog is closed.
      aria-disabled={session.runner.busy.value}
      aria-label={isOff && brief ? program.connectAndWrite : undefined}
      aria-describedby={isBlocked ? NOTE : undefined}
      // While a timer is looked for, there is one way to it.
      disabled={!isConnected && (!isOff || session.link.unavailable !== null)}
      onClick={() => void press()}
    >
      {isOff && !brief ? program.connectAndWrite : program.write(count)}
    </button>
  );
}

/** What is in the way of a write. A text that is still being typed is not. */
export function BlockedNote({ editor }: { readonly editor: Editor }) {
  const text = useComputed(() => {
    const identity = editor.identity.value;
    const cause = identity && firstInTheWay(editor);
    if (!cause) return null;
    const key = fieldKey(cause.field);
    const isTyped = editor.unreadable.value.get(key)?.either && !editor.asked.value.has(key);
    return isTyped ? null : messages.value.program.blocked(fieldLabel(identity, cause.field), cause.text);
  }).value;
  if (text === null) return null;
  return (
    <p class="hint bad-text" id={NOTE} role="status">
      {text}
    </p>
  );
}

/** The large figure where there is one, else the cell. */
function lookAt(key: string): void {
  const input = document.querySelector<HTMLInputElement>(`input[data-field="${CSS.escape(key)}"]`);
  input?.focus({ preventScroll: true });
  input?.scrollIntoView({ block: 'center' });
}
