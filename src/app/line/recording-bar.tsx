import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { Session } from '../work/session.js';
import type { LineView } from './line-view.js';

/** Names the recording that is shown, and what can be done with it; or says why a file is no recording. */
export function RecordingBar({ session, view }: { readonly session: Session; readonly view: LineView }) {
  const { dismiss } = messages.value;
  const { line } = moreMessages.value;
  const recording = view.recording.value;
  const fault = view.fault.value;
  const replay = (): void => {
    if (!recording) return;
    view.back();
    void session.timer.tryRecording(recording.entries);
  };
  return (
    <>
      {fault && (
        <div class="notice bad" role="alert">
          <p>{fault.line === null ? line.noRecording : line.noRecordingAt({ line: fault.line })}</p>
          <button type="button" class="quiet" onClick={() => view.dismissFault()}>
            {dismiss}
          </button>
        </div>
      )}
      {recording && (
        <div class="notice" role="status">
          <p>
            <strong>{line.recording({ name: recording.name, entries: recording.records.length })}</strong>{' '}
            {!recording.replayable && line.cannotReplay}
          </p>
          <div class="buttons">
            <button type="button" disabled={session.engaged.value || !recording.replayable} onClick={replay}>
              {line.replay}
            </button>
            <button type="button" onClick={() => view.back()}>
              {line.back}
            </button>
          </div>
        </div>
      )}
    </>
  );
}
