import { useSignal } from '@preact/signals';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { emptyModel, newId } from '../records/library.js';
import { FormButtons } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import type { Session } from '../work/session.js';
import { ClassChoice } from './class-choice.js';
import { NameField } from './name-field.js';
import './library-form.css';

interface NewModelDialogProps {
  readonly open: boolean;
  readonly session: Session;
  readonly onClose: () => void;
  /** Shows the page of the new model. */
  readonly onMade: (id: string) => void;
}

/** Asks for the name and the class of a new model. */
export function NewModelDialog({ open, session, ...props }: NewModelDialogProps) {
  return (
    <Modal open={open} title={moreMessages.value.library.models.make} onEscape={props.onClose}>
      <Form session={session} {...props} />
    </Modal>
  );
}

function Form({ session, onClose, onMade }: Omit<NewModelDialogProps, 'open'>) {
  const { label, save } = messages.value;
  const name = useSignal('');
  const timerClass = useSignal<string | null>(session.editor.identity.peek()?.timerClass ?? null);
  return (
    <form
      class="stack gap-4 library-form"
      onSubmit={(event) => {
        event.preventDefault();
        const model = emptyModel(newId(), name.value.trim(), timerClass.value);
        void session.library.keepModel(model);
        onClose();
        onMade(model.id);
      }}
    >
      <NameField label={label.name} value={name.value} onChange={(text) => (name.value = text)} />
      <ClassChoice value={timerClass.value} onChange={(letter) => (timerClass.value = letter)} />
      <FormButtons label={save} onCancel={onClose} />
    </form>
  );
}
