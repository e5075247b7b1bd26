import { useEffect, useRef } from 'preact/hooks';
import { COMMAND_NAMES, COMMANDS, type Frame } from '../../protocol/index.js';
import { describeFrame, frameName, hexOf, letterOf } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import { Select } from '../ui/choice.js';
import type { FrameForm } from './frame-form.js';
import './send-frame.css';

/** Sends a frame of the pilot's own, to find out what a timer does. */
export function SendFrame({ form, connected }: { readonly form: FrameForm; readonly connected: boolean }) {
  const { send } = messages.value.line;
  return (
    <details class="send-frame">
      <summary>{send.title}</summary>
      {connected ? (
        <Form form={form} />
      ) : (
        <div>
          <p class="hint">{send.notConnected}</p>
          {form.result.value?.reply === null && <p role="status">{send.unanswered}</p>}
        </div>
      )}
    </details>
  );
}

function Form({ form }: { form: FrameForm }) {
  const { line } = messages.value;
  const { send } = line;
  const button = useRef<HTMLButtonElement>(null);
  const step = form.step.value;
  const dataFault = form.dataFault.value;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void form.send();
      }}
    >
      <p class="hint">{send.lead}</p>
      <div class="send-fields">
        <label>
          <span>{send.command}</span>
          <Select
            choices={[...COMMAND_NAMES, null]}
            nameOf={(name) =>
              name ? send.choice(line.names[name], name, letterOf(COMMANDS[name].request)) : send.other
            }
            chosen={form.command.value}
            onChoose={(command) => form.edit({ command })}
          />
        </label>
        {form.command.value === null && (
          <HexField
            id="frame-letter"
            label={send.letter}
            value={form.letter.value}
            fault={form.letter.value && form.letterFault.value ? send.faults[form.letterFault.value] : null}
            onType={(letter) => form.edit({ letter })}
          />
        )}
        <HexField
          id="frame-data"
          label={send.data}
          value={form.data.value}
          fault={dataFault && send.faults[dataFault]}
          onType={(data) => form.edit({ data })}
        />
      </div>
      <Preview form={form} />
      <div class="buttons">
        <button ref={button} type="submit" class="primary" aria-disabled={!form.ready.value || step !== 'edit'}>
          {form.frame.value && form.effect.value !== 'reads' ? send.send : send.sendNow}
        </button>
      </div>
      {step === 'confirm' && <Confirm form={form} onLeave={() => button.current?.focus()} />}
      <div class="send-result" role="status">
        {step === 'sending' && <p>{send.sending}</p>}
        {form.result.value && <Result form={form} reply={form.result.value.reply} />}
      </div>
    </form>
  );
}

interface HexFieldProps {
  readonly id: string;
  readonly label: string;
  readonly value: string;
  /** Why the typed text cannot be sent. */
  readonly fault: string | null;
  readonly onType: (text: string) => void;
}

function HexField({ id, label, value, fault, onType }: HexFieldProps) {
  const faultId = `${id}-fault`;
  return (
    <div class="stack gap-1 hex-field">
      <label>
        <span>{label}</span>
        <input
          type="text"
          class="hex"
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          value={value}
          aria-invalid={fault !== null}
          aria-describedby={fault === null ? undefined : faultId}
          onInput={(event) => onType(event.currentTarget.value)}
        />
      </label>
      {fault !== null && (
        <span id={faultId} class="bad-text">
          {fault}
        </span>
      )}
    </div>
  );
}

/** The frame as it would go out, and its meaning. */
function Preview({ form }: { form: FrameForm }) {
  const { send } = messages.value.line;
  const frame = form.frame.value;
  const bytes = form.bytes.value;
  if (!frame || !bytes) return null;
  return (
    <p class="stack frame-preview">
      {send.preview} <code>{hexOf(bytes)}</code> <Words form={form} frame={frame} direction="out" />
    </p>
  );
}

/** What may happen, and the button that sends it. */
function Confirm({ form, onLeave }: { form: FrameForm; onLeave: () => void }) {
  const { send } = messages.value.line;
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    // Not on the button: a key that is held down would press it.
    box.current?.focus();
    return onLeave;
  }, []);
  return (
    <div
      ref={box}
      class="notice bad confirm"
      role="alertdialog"
      tabIndex={-1}
      aria-labelledby="confirm-title"
      aria-describedby="confirm-text"
      onKeyDown={(event) => event.key === 'Escape' && form.cancel()}
    >
      <p>
        <strong id="confirm-title">{send.confirmTitle}</strong>{' '}
        <span id="confirm-text">
          {send.danger[form.effect.value]} {send.safety}
        </span>
      </p>
      <div class="buttons">
        <button type="button" disabled={!form.ready.value} onClick={() => void form.confirm()}>
          {send.confirm}
        </button>
        <button type="button" onClick={() => form.cancel()}>
          {send.cancel}
        </button>
      </div>
    </div>
  );
}

function Result({ form, reply }: { form: FrameForm; reply: Frame | null }) {
  const { send } = messages.value.line;
  if (!reply) return <p>{send.unanswered}</p>;
  return (
    <p>
      <strong>{send.answered}</strong> <Words form={form} frame={reply} direction="in" />
    </p>
  );
}

function Words({ form, frame, direction }: { form: FrameForm; frame: Frame; direction: 'in' | 'out' }) {
  const seen = { direction, frame, rejected: null, error: null };
  return (
    <>
      <span class="name">{frameName(seen)}</span> <span class="meaning">{describeFrame(seen, form.layout)}</span>
    </>
  );
}
