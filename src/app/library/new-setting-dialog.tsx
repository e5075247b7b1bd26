import { useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { CLASSES, LAYOUTS, newProgram, USUAL_LAYOUT } from '../editing/new-program.js';
import { messages } from '../messages/index.js';
import { libraryMessages } from '../messages/library.js';
import { newId } from '../session/library.js';
import type { Session } from '../session/session.js';
import type { ModelRecord } from '../storage/index.js';
import { CountChoice } from '../ui/count-choice.js';
import { FormButtons } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { NameField } from './name-field.js';
import { addressPath } from './place.js';
import './library-form.css';

interface NewSettingDialogProps {
  readonly open: boolean;
  readonly session: Session;
  /** The model that it is for; null for none. */
  readonly model: ModelRecord | null;
  readonly onClose: () => void;
  /** Goes to the place of the new setting in the library. */
  readonly onMade: (path: string) => void;
}

/** Makes a setting without a timer, from usual times or from nothing. */
export function NewSettingDialog({ open, ...props }: NewSettingDialogProps) {
  const { newSetting: words } = libraryMessages.value;
  return (
    <Modal open={open} title={words.title} onEscape={props.onClose}>
      <Form {...props} />
    </Modal>
  );
}

function Form({ session, model, onClose, onMade }: Omit<NewSettingDialogProps, 'open'>) {
  const { save, newSetting } = libraryMessages.value;
  const { newProgram: words, classNames } = messages.value;
  const group = useId();
  // With the layout of the model's other settings.
  const like = session.library.settings.list.peek().find(({ setting }) => setting.model === (model?.key ?? null));
  const known = like?.setting.program.identity;
  const name = useSignal('');
  const own = CLASSES.find((each) => each === (model?.model.timerClass ?? known?.timerClass));
  const timerClass = useSignal<(typeof CLASSES)[number]>(own ?? 'Q');
  const functions = useSignal(known?.functions ?? USUAL_LAYOUT.functions);
  const servos = useSignal(known?.servos ?? USUAL_LAYOUT.servos);
  const from = useSignal<'usual' | 'nothing'>('usual');
  return (
    <form
      class="library-form"
      onSubmit={(event) => {
        event.preventDefault();
        const program = newProgram({
          timerClass: timerClass.value,
          functions: functions.value,
          servos: servos.value,
          from: from.value,
        });
        const setting = {
          id: newId(),
          model: model?.key ?? null,
          name: name.value.trim(),
          note: '',
          tags: [],
          at: Date.now(),
          program,
          from: 'typed' as const,
          archived: false,
        };
        void session.library.keepSetting(setting);
        onClose();
        onMade(addressPath(setting.model, setting.id));
      }}
    >
      <NameField
        label={save.name}
        placeholder={save.namePlace}
        value={name.value}
        onChange={(text) => (name.value = text)}
      />
      <SegmentChoice
        name={`${group}-class`}
        title={words.timerClass}
        choices={CLASSES}
        names={classNames as Record<(typeof CLASSES)[number], string>}
        chosen={timerClass.value}
        onChoose={(choice) => (timerClass.value = choice)}
      />
      <div class="library-pair">
        <CountChoice
          label={words.functions}
          range={LAYOUTS.functions}
          value={functions.value}
          // The wire counts DT as a function; a pilot does not.
          shown={(count) => count - 1}
          onChoose={(count) => (functions.value = count)}
        />
        <CountChoice
          label={words.servos}
          range={LAYOUTS.servos}
          value={servos.value}
          onChoose={(count) => (servos.value = count)}
        />
      </div>
      <SegmentChoice
        name={`${group}-from`}
        title={words.from}
        choices={['usual', 'nothing'] as const}
        names={newSetting.beginnings}
        chosen={from.value}
        onChoose={(choice) => (from.value = choice)}
      />
      <p class="hint">{words.caution}</p>
      <FormButtons label={newSetting.make} onCancel={onClose} />
    </form>
  );
}
