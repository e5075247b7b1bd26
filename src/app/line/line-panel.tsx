import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { Session } from '../work/session.js';
import type { FrameForm } from './frame-form.js';
import { LineRows } from './line-rows.js';
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
    <div class="stack gap-3 line-body">
      <h1>{messages.value.views.names.line}</h1>
      <LineTools session={session} view={view} />
      {/* Above the log, which can be very long. */}
      {!unused && <SendFrame session={session} form={form} />}
      <RecordingBar session={session} view={view} />
      {unused ? <p class="hint">{moreMessages.value.line.unused}</p> : <LineRows view={view} />}
    </div>
  );
}
