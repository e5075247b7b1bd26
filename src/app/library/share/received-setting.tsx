import { useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { decodeLink, type Setting, type SharedSetting } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { apart } from '../../messages/apart.js';
import { dotted } from '../../messages/dotted.js';
import { dateText, messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { servoName, timerText } from '../../messages/names.js';
import { emptyModel, newId } from '../../records/library.js';
import { plainName, withPlainNames } from '../../records/plain-names.js';
import { hasSameValues } from '../../records/versions.js';
import type { ModelRecord } from '../../storage/index.js';
import { Choice } from '../../ui/choice.js';
import { Problem } from '../../ui/problem.js';
import type { Session } from '../../work/session.js';
import { ProgramFacts } from '../program-facts.js';
import type { Sharing } from './sharing.js';

interface ReceivedSettingProps {
  readonly session: Session;
  readonly sharing: Sharing;
  readonly link: string;
  readonly onProgram: () => void;
  readonly onLibrary: (model: string | null, key: string) => void;
}

/** The setting in a link: to look at, keep, open, or ignore. It is not kept until the pilot says so. */
export function ReceivedSetting(props: ReceivedSettingProps) {
  const { session, sharing, link } = props;
  const read = useMemo(() => sharedIn(link), [link]);
  useEffect(() => void session.library.load(), [session]);
  if (!(read instanceof CodecError)) return <Shown {...props} shared={read} />;
  const { damaged } = moreMessages.value.share;
  return (
    <>
      <div class="notice bad" role="alert">
        <p>
          <strong>{damaged.title}</strong>{' '}
          {read.code === 'newer-version' ? moreMessages.value.files.refused.newer : damaged.bad}
        </p>
      </div>
      <div class="buttons">
        <button type="button" class="primary" onClick={() => sharing.close()}>
          {messages.value.close}
        </button>
      </div>
    </>
  );
}

/** Stands in place of a model's id: the setting goes under a new model. */
const NEW_MODEL = 'new model';

function Shown(props: ReceivedSettingProps & { readonly shared: SharedSetting }) {
  const { session, sharing, shared, onProgram, onLibrary } = props;
  const { received: words } = moreMessages.value.share;
  const { noModel, open: openWord } = messages.value;
  const { library, opened, editor } = session;
  const { modelName, program, note, tags } = shared;
  const chosen = useSignal<string | null | undefined>(undefined);
  const failed = useSignal(false);
  const models = library.models.list.value.filter(({ model }) => !model.archived);
  const place = chosen.value === undefined ? placeFor(modelName, models) : chosen.value;
  const known = library.settings.list.value.find(
    ({ setting }) => setting.name === shared.name && hasSameValues(setting.program, program),
  )?.setting;
  const obstacle = opened.obstacle(program);
  // Until then the models are not known, and one might be made twice.
  const isLoaded = library.models.loaded.value && library.settings.loaded.value;
  const open = async (): Promise<void> => {
    failed.value = !(await opened.show(settingOf(shared, null)));
    if (failed.peek()) return;
    sharing.close();
    onProgram();
  };
  const keep = (): void => {
    const model = place === NEW_MODEL ? emptyModel(newId(), modelName, program.identity.timerClass) : null;
    if (model) void library.keepModel(model);
    const setting = settingOf(shared, model?.id ?? place);
    void library.keepSetting(setting);
    sharing.close();
    onLibrary(setting.model, setting.id);
  };
  return (
    <>
      <div class="stack gap-1">
        <p>
          <strong>{shared.name}</strong> {apart(modelName)}
        </p>
        <p class="hint">{dotted([timerText(program.identity), dateText(shared.at)])}</p>
        <p class="hint">
          {known
            ? words.known({ name: dotted([library.models.get(known.model)?.model.name, known.name]) })
            : words.lead}
        </p>
      </div>
      {/* Above the values: where it would go must be in sight with the button that keeps it. */}
      <Choice
        label={words.modelChoice}
        choices={[...(modelName ? [NEW_MODEL] : []), null, ...models.map(({ key }) => key)]}
        nameOf={(key) =>
          key === NEW_MODEL ? words.newModel({ name: modelName }) : (library.models.get(key)?.model.name ?? noModel)
        }
        chosen={place}
        onChoose={(key) => (chosen.value = key)}
      />
      <ProgramFacts program={program} names={program.positions.map((_, servo) => servoName(servo))} />
      {note !== '' && <p class="as-typed">{note}</p>}
      {tags.length > 0 && <p class="hint">{tags.join(', ')}</p>}
      {obstacle !== null && <p class="hint">{moreMessages.value.obstacles[obstacle]}</p>}
      {obstacle === null && editor.dirty.value && <p class="hint">{words.unwritten}</p>}
      <Problem text={failed.value && moreMessages.value.library.setting.notShown} />
      <div class="buttons">
        <button type="button" class="quiet" onClick={() => sharing.close()}>
          {words.discard}
        </button>
        <button type="button" disabled={obstacle !== null} onClick={() => void open()}>
          {openWord}
        </button>
        <button type="button" class="primary" disabled={!isLoaded} onClick={keep}>
          {words.keep}
        </button>
      </div>
    </>
  );
}

/** Under the model of this name, if there is one and no other. */
function placeFor(name: string, models: readonly ModelRecord[]): string | null {
  const [only, ...more] = models.filter(({ model }) => model.name === name);
  if (only && more.length === 0) return only.key;
  return name === '' || only ? null : NEW_MODEL;
}

function settingOf({ modelName: _, ...values }: SharedSetting, model: string | null): Setting {
  return { ...values, id: newId(), model, from: 'link', archived: false };
}

/** As it would be kept: it is shown in sentences, and compared with what is there. */
function sharedIn(link: string): SharedSetting | CodecError {
  try {
    const shared = decodeLink(link);
    const { name, note, tags, at, program } = withPlainNames(settingOf(shared, null));
    return { name, note, tags, at, program, modelName: plainName(shared.modelName) };
  } catch (cause) {
    if (cause instanceof CodecError) return cause;
    throw cause;
  }
}
