import { useComputed } from '@preact/signals';
import { fieldKey, type ProgramField } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { fieldName, messages } from '../messages/index.js';
import { firstInTheWay } from '../work/field-notes.js';
import type { Session } from '../work/session.js';
import { comeBack } from '../write/edit-memory.js';
import type { WriteJob } from '../write/write-job.js';

const NOTE = 'blocked-note';

interface WriteButtonProps {
  readonly session: Session;
  readonly write: WriteJob;
  /** For places with little room. */
  readonly brief: boolean;
  /** Goes to a field of the table. */
  readonly onField: (field: ProgramField) => void;
}

/**
 * Opens the difference, and from there the write; without a timer it connects first. When a field prevents the write,
 * it goes to that field.
 */
export function WriteButton({ session, write, brief, onField }: WriteButtonProps) {
  const { editor } = session;
  const isBlocked = useComputed(() => editor.blocked.value).value;
  const count = useComputed(() => editor.changes.value.length).value;
  const isConnected = session.connection.value !== null;
  const isOff = session.link.state.value.status === 'off';
  // Where no port can be opened, a simulated timer still comes back.
  const canConnect = session.link.unavailable === null || session.timer.simulated !== undefined;
  const { program, header } = messages.value;
  const press = async (): Promise<void> => {
    const cause = editor.blocked.value ? firstInTheWay(editor) : null;
    if (cause) return onField(cause.field);
    if (!isConnected && !(await comeBack(session))) return;
    // The connection may take long, and by then the pilot may want something else.
    if (session.runner.ready.value) void write.open();
  };
  return (
    <button
      type="button"
      class={isBlocked ? 'blocked' : count > 0 ? 'primary' : ''}
      // Not during a job. The button keeps the focus, also for when the dialog closes.
      aria-disabled={session.runner.busy.value}
      aria-label={isOff && brief ? program.connectAndWrite : undefined}
      aria-describedby={isBlocked ? NOTE : undefined}
      // While the page looks for a timer, this is not a second way to connect.
      disabled={!isConnected && !(isOff && canConnect)}
      onClick={() => void press()}
    >
      {isOff ? (brief ? `${header.connect}…` : program.connectAndWrite) : program.write({ count })}
    </button>
  );
}

/** What prevents a write. A text that is still being typed does not. */
export function BlockedNote({ editor }: { readonly editor: Editor }) {
  const text = useComputed(() => {
    const identity = editor.identity.value;
    const cause = identity && firstInTheWay(editor);
    if (!cause) return null;
    const key = fieldKey(cause.field);
    const isTyped = editor.unreadable.value.get(key)?.either && !editor.asked.value.has(key);
    return isTyped
      ? null
      : messages.value.program.blocked({ field: fieldName(identity, cause.field), why: cause.text });
  }).value;
  if (text === null) return null;
  return (
    <p class="hint bad-text" id={NOTE} role="status">
      {text}
    </p>
  );
}
