import { useSignal } from '@preact/signals';
import { CLASSES, type NewProgram, newProgram, USUAL_LAYOUT } from '../editing/new-program.js';
import { libraryMessages } from '../messages/en-library.js';
import { messages } from '../messages/index.js';
import { newId } from '../session/library.js';
import type { Session } from '../session/session.js';
import type { ModelRecord } from '../storage/index.js';
import { FormButtons } from '../ui/form-buttons.js';
import { LayoutChoice } from '../ui/layout-choice.js';
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
  return (
    <Modal open={open} title={libraryMessages.model.makeSetting} onEscape={props.onClose}>
      <Form {...props} />
    </Modal>
  );
}

function Form({ session, model, onClose, onMade }: Omit<NewSettingDialogProps, 'open'>) {
  const { save } = libraryMessages;
  const { newProgram: words, save: send } = messages.value;
  // With the layout of the model's other settings.
  const like = session.library.settings.list.peek().find(({ setting }) => setting.model === (model?.key ?? null));
  const known = like?.setting.program.identity;
  const name = useSignal('');
  const own = CLASSES.find((each) => each === (model?.model.timerClass ?? known?.timerClass));
  const wanted = useSignal<NewProgram>({
    timerClass: own ?? 'Q',
    functions: known?.functions ?? USUAL_LAYOUT.functions,
    servos: known?.servos ?? USUAL_LAYOUT.servos,
    from: 'usual',
  });
  const choose = (part: Partial<NewProgram>): void => {
    wanted.value = { ...wanted.value, ...part };
  };
  return (
    <form
      class="stack gap-4 library-form"
      onSubmit={(event) => {
        event.preventDefault();
        const setting = {
          id: newId(),
          model: model?.key ?? null,
          name: name.value.trim(),
          note: '',
          tags: [],
          at: Date.now(),
          program: newProgram(wanted.value),
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
      <LayoutChoice wanted={wanted.value} onChoose={choose} />
      <SegmentChoice
        name="new-from"
        title={words.from}
        choices={['usual', 'nothing'] as const}
        names={words.beginnings}
        chosen={wanted.value.from}
        onChoose={(from) => choose({ from })}
      />
      <p class="hint">{words.caution}</p>
      <FormButtons label={send} onCancel={onClose} />
    </form>
  );
}
