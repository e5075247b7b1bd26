import { words } from '../messages/en-guide.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { Modal } from '../ui/modal.js';
import type { Help } from './help.js';
import './field-words.css';

type Field = keyof typeof words.fields;
const FIELDS = Object.keys(words.fields) as Field[];
/** Fields that only a timer with a motor has. */
const MOTOR: ReadonlySet<Field> = new Set(['motorStop', 'idleThrottle']);

/** Explains each value in full. */
export function WordsPage() {
  return (
    <dl class="stack gap-3 field-words">
      {FIELDS.map((field) => {
        const { name, short, range } = words.fields[field];
        return (
          <div key={field}>
            <dt>{name}</dt>
            <dd>
              <p>{short}</p>
              {range && <p class="field-range">{range}</p>}
            </dd>
          </div>
        );
      })}
    </dl>
  );
}

interface WordsDialogProps {
  readonly help: Help;
  readonly session: Session;
  /** Opens the full explanation. */
  readonly onMore: () => void;
}

/** The same in short, over the table that it explains. */
export function WordsDialog({ help, session, onMore }: WordsDialogProps) {
  const isOpen = help.explaining.value;
  // While it is closed, a change of program must not draw it.
  const hasMotor = isOpen && session.editor.identity.value?.timerClass === 'Q';
  const close = (): void => help.explain(false);
  return (
    <Modal open={isOpen} title={words.title} onEscape={close}>
      <dl class="stack gap-3 field-words">
        {FIELDS.filter((field) => hasMotor || !MOTOR.has(field)).map((field) => (
          <div key={field}>
            <dt>{words.fields[field].name}</dt>
            <dd>
              <p>{words.fields[field].short}</p>
              <p class="field-range">{words.fields[field].range}</p>
            </dd>
          </div>
        ))}
      </dl>
      <div class="buttons">
        <button
          type="button"
          class="quiet"
          onClick={() => {
            close();
            onMore();
          }}
        >
          {words.more}
        </button>
        <button type="button" class="primary" onClick={close}>
          {messages.value.close}
        </button>
      </div>
    </Modal>
  );
}
