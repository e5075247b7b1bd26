import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { FrameForm } from './frame-form.js';
import { LineTable } from './line-table.js';
import { LineTools } from './line-tools.js';
import { LineView } from './line-view.js';
import { RecordingBar } from './recording-bar.js';
import { SendFrame } from './send-frame.js';
import './line-panel.css';

/** Everything that was on the line, or in a recording of one. While it is shut nothing of it is drawn. */
export function LinePanel({ session }: { readonly session: Session }) {
  const open = useSignal(false);
  const view = useMemo(() => new LineView(session.log), [session]);
  const form = useMemo(() => new FrameForm(session), [session]);
  return (
    <details class="line" onToggle={(event) => (open.value = event.currentTarget.open)}>
      <summary>{messages.value.line.title}</summary>
      {open.value && <Opened session={session} view={view} form={form} />}
    </details>
  );
}

function Opened({
  session,
  view,
  form,
}: {
  readonly session: Session;
  readonly view: LineView;
  readonly form: FrameForm;
}) {
  const unused = view.unused.value;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the button beside it takes a file too
    <div
      class="line-body"
      onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => {
        event.preventDefault();
        const file = event.dataTransfer?.files[0];
        if (file) void view.load(file);
      }}
    >
      <LineTools session={session} view={view} />
      <RecordingBar session={session} view={view} />
      {unused ? <p class="hint">{messages.value.line.unused}</p> : <LineTable view={view} />}
      {!unused && <SendFrame form={form} connected={session.connection.value !== null} />}
    </div>
  );
}
