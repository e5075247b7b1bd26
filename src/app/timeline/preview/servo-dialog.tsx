import { useSignal } from '@preact/signals';
import { Fragment } from 'preact';
import { DUTIES, LIMITS, type ServoUse } from '../../../program/index.js';
import { MAX_POSITION } from '../../../protocol/index.js';
import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { servoName } from '../../messages/names.js';
import { Select } from '../../ui/choice.js';
import { FormButtons } from '../../ui/form-buttons.js';
import { Modal } from '../../ui/modal.js';
import { servoColour } from '../servo-colour.js';
import { SURFACES } from './surfaces.js';
import './servo-dialog.css';

interface ServoDialogProps {
  readonly open: boolean;
  /** The uses of all servos, as said or guessed so far. */
  readonly uses: readonly ServoUse[];
  /** Null: guess them. */
  readonly onSave: (uses: readonly ServoUse[] | null) => void;
  readonly onCancel: () => void;
}

/** The pilot, with the model in front of him, says what each servo moves, over which steps, and in which direction. */
export function ServoDialog({ open, onCancel, ...form }: ServoDialogProps) {
  return (
    <Modal open={open} title={moreMessages.value.preview.nameServos} onEscape={onCancel}>
      <ServoForm onCancel={onCancel} {...form} />
    </Modal>
  );
}

function ServoForm({ uses, onSave, onCancel }: Omit<ServoDialogProps, 'open'>) {
  const { save } = messages.value;
  const { preview } = moreMessages.value;
  const draft = useSignal(uses);
  return (
    <form
      class="stack gap-3 servo-form"
      onSubmit={(event) => {
        event.preventDefault();
        // A model without servos is none: nothing is said of it.
        onSave(draft.value.some(({ duty }) => duty !== 'none') ? draft.value.map(inOrder) : null);
      }}
    >
      <p class="hint">{preview.naming.lead}</p>
      {draft.value.map((use, servo) => (
        <ServoRow
          key={servoName(servo)}
          servo={servo}
          use={use}
          onChange={(changed) => {
            draft.value = draft.value.map((other, at) => (at === servo ? { ...other, ...changed } : other));
          }}
        />
      ))}
      <FormButtons label={save} onCancel={onCancel} />
    </form>
  );
}

/** The two ends may come in any order. */
function inOrder({ low, high, name, ...use }: ServoUse): ServoUse {
  return {
    ...use,
    name: use.duty === 'other' ? name.trim() : '',
    low: Math.min(low, high),
    high: Math.max(low, high),
  };
}

/** The ends of a servo's travel, each with the word before it. */
const ENDS = [
  ['low', 'from'],
  ['high', 'to'],
] as const;

interface ServoRowProps {
  readonly servo: number;
  readonly use: ServoUse;
  readonly onChange: (changed: Partial<ServoUse>) => void;
}

function ServoRow({ servo, use, onChange }: ServoRowProps) {
  const { timeline } = messages.value;
  const { preview } = moreMessages.value;
  const { naming: words, duties } = preview;
  const name = servoName(servo);
  const isSurface = SURFACES.some((surface) => surface === use.duty);
  return (
    <fieldset class="row servo-row" {...servoColour(servo)}>
      <legend>{name}</legend>
      <Select
        name={words.duty({ servo: name })}
        choices={DUTIES}
        nameOf={(duty) => duties[duty]}
        chosen={use.duty}
        onChoose={(duty) => onChange({ duty })}
      />
      {use.duty === 'other' && (
        <input
          type="text"
          aria-label={words.name({ servo: name })}
          value={use.name}
          maxLength={LIMITS.servoName}
          onInput={(event) => onChange({ name: event.currentTarget.value })}
        />
      )}
      {isSurface && (
        <>
          <span class="row servo-way">
            {ENDS.map(([end, before]) => (
              <Fragment key={end}>
                <span aria-hidden="true">{words[before]}</span>
                {/* The browser itself refuses a text that is no step. */}
                <input
                  type="number"
                  inputMode="numeric"
                  aria-label={words[end]({ servo: name })}
                  min={0}
                  max={MAX_POSITION}
                  step={1}
                  required
                  value={Number.isFinite(use[end]) ? use[end] : ''}
                  onChange={(event) => onChange({ [end]: event.currentTarget.valueAsNumber })}
                />
              </Fragment>
            ))}
            <span aria-hidden="true">{timeline.stepsUnit}</span>
          </span>
          <Select
            name={words.sense({ servo: name })}
            choices={[false, true]}
            nameOf={(reversed) => (use.duty === 'rudder' ? words.rudderSense : words.otherSense)[`${reversed}`]}
            chosen={use.reversed}
            onChoose={(reversed) => onChange({ reversed })}
          />
        </>
      )}
    </fieldset>
  );
}
