import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { FrameForm } from './frame-form.js';
import { LineTable } from './line-table.js';
import { LineTools } from './line-tools.js';
import type { LineView } from './line-view.js';
import { RecordingBar } from './recording-bar.js';
import { SendFrame } from './send-frame.js';
import './line-panel.css';

export interface LinePanelProps {
  readonly session: Session;
  readonly view: LineView;
  readonly form: FrameForm;
}

/** Everything that was on the line, or in a recording. */
export function LinePanel({ session, view, form }: LinePanelProps) {
  const unused = view.unused.value;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the button beside it takes a file too
    <div
      class="stack gap-3 line-body"
      onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => {
        event.preventDefault();
        const file = event.dataTransfer?.files[0];
        if (file) void view.load(file);
      }}
    >
      <h1>{messages.value.line.title}</h1>
      <LineTools session={session} view={view} />
      {/* Above the log, which can be very long. */}
      {!unused && <SendFrame form={form} connected={session.connection.value !== null} />}
      <RecordingBar session={session} view={view} />
      {unused ? <p class="hint">{messages.value.line.unused}</p> : <LineTable view={view} />}
    </div>
  );
}
