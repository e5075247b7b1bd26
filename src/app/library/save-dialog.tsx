import { useSignal } from '@preact/signals';
import { LIMITS } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { programOf } from '../messages/names.js';
import { plainName } from '../records/plain-names.js';
import { Check } from '../ui/check.js';
import { Choice } from '../ui/choice.js';
import { FormButtons } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import { Problem } from '../ui/problem.js';
import type { Session } from '../work/session.js';
import { NameField } from './name-field.js';
import type { SaveSetting } from './save-setting.js';
import './library-form.css';

interface SaveDialogProps {
  readonly session: Session;
  readonly saveSetting: SaveSetting;
}

/** Asks how to save the program on the screen. */
export function SaveDialog({ session, saveSetting }: SaveDialogProps) {
  const { save: words } = moreMessages.value.library;
  return (
    <Modal open={saveSetting.asking.value} title={words.open} onEscape={() => saveSetting.dismiss()}>
      <NameForm {...{ session, saveSetting }} />
    </Modal>
  );
}

/** Can be no id of a model. */
const NEW = ' new';
const NONE = '';

function NameForm({ session, saveSetting }: SaveDialogProps) {
  const { save: words } = moreMessages.value.library;
  const { label, noModel, save } = messages.value;
  const { library, opened, origin } = session;
  const open = origin.setting.peek();
  const whose = origin.model.value;
  const crossed = useSignal(false);
  const replaces = useSignal(false);
  const name = useSignal(open?.name ?? '');
  const note = useSignal('');
  const modelName = useSignal('');
  const model = useSignal(open ? (origin.model.peek()?.id ?? NONE) : (suggested(session) ?? NEW));
  const to = library.models.get(model.value)?.model;
  // Two of one name nobody could tell apart.
  const same = library.settings.list.value.find(
    ({ setting }) => setting.model === (model.value || null) && setting.name === plainName(name.value),
  )?.setting;
  const isOther = whose !== null && to !== undefined && to.id !== whose.id;
  return (
    <form
      class="stack gap-4 library-form"
      onSubmit={(event) => {
        event.preventDefault();
        const under = model.value === NEW ? { name: modelName.value.trim() } : model.value || null;
        void saveSetting.saveAs({ name: name.value.trim(), note: note.value, model: under, over: same ?? null });
      }}
    >
      <NameField
        label={words.name({ of: 'program' })}
        placeholder={words.namePlace}
        value={name.value}
        onChange={(text) => {
          name.value = text;
          replaces.value = false;
        }}
      />
      <Choice
        label={label.model}
        choices={[...library.models.list.value.map(({ key }) => key), NEW, NONE]}
        nameOf={(key) =>
          key === NEW ? moreMessages.value.library.models.make : (library.models.get(key)?.model.name ?? noModel)
        }
        chosen={model.value}
        onChoose={(key) => {
          model.value = key;
          crossed.value = false;
          replaces.value = false;
        }}
      />
      {model.value === NEW && (
        <NameField
          label={words.name({ of: 'model' })}
          value={modelName.value}
          onChange={(text) => (modelName.value = text)}
        />
      )}
      <label class="field">
        <span>{label.note}</span>
        <textarea
          rows={2}
          maxLength={LIMITS.note}
          value={note.value}
          onInput={({ currentTarget }) => (note.value = currentTarget.value)}
        />
      </label>
      {isOther && (
        <Check checked={crossed.value} onChange={(on) => (crossed.value = on)}>
          {words.crossing({ from: whose.name, to: to.name })}
        </Check>
      )}
      {same && (
        <div class="stack gap-1">
          <p role="status">{words.taken({ program: programOf(same.name, to?.name ?? '') })}</p>
          <Check checked={replaces.value} onChange={(on) => (replaces.value = on)}>
            {words.replace}
          </Check>
        </div>
      )}
      <Problem text={!opened.savable.value && words.notSavable} />
      <FormButtons
        label={save}
        disabled={!opened.savable.value || (isOther && !crossed.value) || (same !== undefined && !replaces.value)}
        onCancel={() => saveSetting.dismiss()}
      />
    </form>
  );
}

/** The model that it is probably for: whose the values are, or the only one of its class. */
function suggested({ library, editor, origin }: Session): string | null {
  const whose = origin.model.peek();
  if (whose) return whose.id;
  const timerClass = editor.identity.peek()?.timerClass;
  const [first, ...more] = library.models.list
    .peek()
    .filter(({ model }) => !model.archived && model.timerClass === timerClass);
  return first && more.length === 0 ? first.key : null;
}
