import type { Frame } from '../../protocol/index.js';
import { describeFrame, frameName } from '../messages/frame-text.js';
import { hexOf } from '../messages/hex.js';
import { moreMessages } from '../messages/more.js';
import { Modal } from '../ui/modal.js';
import type { Session } from '../work/session.js';
import { StartButtons } from '../write/start-buttons.js';
import type { FrameForm } from './frame-form.js';
import './send-frame.css';

interface SendFrameProps {
  readonly session: Session;
  readonly form: FrameForm;
}

/** Sends a frame of the pilot's own, to find out what a timer does. */
export function SendFrame({ session, form }: SendFrameProps) {
  const { send } = moreMessages.value.line;
  const result = form.result.value;
  return (
    <details class="panel send-frame">
      <summary>{send.title}</summary>
      <form
        class="stack gap-3"
        onSubmit={(event) => {
          event.preventDefault();
          form.ask();
        }}
      >
        <p class="hint">{send.lead}</p>
        <Bytes form={form} />
        <Preview form={form} />
        <div class="buttons">
          <button type="submit" class="primary" disabled={!form.ready.value}>
            {send.send}
          </button>
        </div>
        <div role="status">
          {form.sending.value && <p>{send.sending}</p>}
          {result && (
            <p>
              {result.reply ? <strong>{send.answered}</strong> : send.unanswered}{' '}
              {result.reply && <Words form={form} frame={result.reply} direction="in" />}
            </p>
          )}
        </div>
      </form>
      <Confirm session={session} form={form} />
    </details>
  );
}

function Bytes({ form }: { readonly form: FrameForm }) {
  const { send } = moreMessages.value.line;
  const fault = form.fault.value;
  return (
    <div class="stack gap-1">
      <label class="field">
        <span>{send.bytes}</span>
        <input
          type="text"
          class="hex"
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          value={form.typed.value}
          aria-invalid={fault !== null}
          aria-describedby={fault ? 'frame-fault' : undefined}
          onInput={(event) => form.type(event.currentTarget.value)}
        />
      </label>
      {fault && (
        <span id="frame-fault" class="bad-text">
          {send.faults[fault]}
        </span>
      )}
    </div>
  );
}

/** The frame as it would go out, and its meaning. */
function Preview({ form }: { readonly form: FrameForm }) {
  const frame = form.frame.value;
  if (!frame || !form.bytes.value) return null;
  return (
    <p class="stack frame-preview">
      {moreMessages.value.line.send.preview} <code>{hexOf(form.bytes.value)}</code>{' '}
      <Words form={form} frame={frame} direction="out" />
    </p>
  );
}

/** What may happen, and the button that sends it. */
function Confirm({ session, form }: SendFrameProps) {
  const { send } = moreMessages.value.line;
  const isSafe = session.safety.confirmed.value;
  return (
    <Modal open={form.asking.value} title={send.confirmTitle} onEscape={() => form.cancel()}>
      <p>{send.danger}</p>
      <Preview form={form} />
      <StartButtons
        safety={session.safety}
        ready={form.ready.value && isSafe}
        unticked={isSafe ? [] : ['safety']}
        label={send.confirm}
        onCancel={() => form.cancel()}
        onStart={() => void form.confirm()}
      />
    </Modal>
  );
}

interface WordsProps {
  readonly form: FrameForm;
  readonly frame: Frame;
  readonly direction: 'in' | 'out';
}

function Words({ form, frame, direction }: WordsProps) {
  const seen = { direction, frame, rejected: null, error: null };
  return (
    <>
      <b>{frameName(seen)}</b> <span class="hint">{describeFrame(seen, form.layout)}</span>
    </>
  );
}
