import { useSignal } from '@preact/signals';
import { useEffect, useId, useMemo } from 'preact/hooks';
import type { SharedSetting } from '../../../program/index.js';
import { apart } from '../../messages/apart.js';
import { dotted } from '../../messages/dotted.js';
import { filesMessages } from '../../messages/en-files.js';
import { libraryMessages } from '../../messages/en-library.js';
import { share } from '../../messages/en-share.js';
import { dateText, messages } from '../../messages/index.js';
import type { Session } from '../../session/session.js';
import { SmallLanes } from '../../timeline/small-lanes.js';
import { KeyFigures } from '../../ui/key-figures.js';
import { Problem } from '../../ui/problem.js';
import { TimesTable } from '../../ui/slot-table.js';
import { obstacleText } from '../obstacle-text.js';
import { NO_MODEL } from '../place.js';
import { timerText } from '../timer-text.js';
import { NEW_MODEL, Received } from './received.js';
import type { Sharing } from './sharing.js';
import './received-setting.css';

interface ReceivedSettingProps {
  readonly session: Session;
  readonly sharing: Sharing;
  readonly link: string;
  readonly onProgram: () => void;
  readonly onLibrary: (model: string | null, key: string) => void;
}

/** The setting in a link: to look at, keep, open, or ignore. */
export function ReceivedSetting(props: ReceivedSettingProps) {
  const { session, sharing, link } = props;
  const received = useMemo(() => new Received(session, link), [session, link]);
  useEffect(() => void session.library.load(), [session]);
  const { shared, isNewer } = received;
  const { damaged } = share;
  if (!shared) {
    return (
      <>
        <div class="notice bad" role="alert">
          <p>
            <strong>{damaged.title}</strong> {isNewer ? filesMessages.refused.newer : damaged.bad}
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
  return (
    <>
      <Head shared={shared} isKept={received.kept.value !== null || received.known.value !== null} />
      {/* Above the values: where it would go must be in sight with the button that keeps it. */}
      {!received.kept.value && <Place session={session} received={received} shared={shared} />}
      <Values shared={shared} />
      <Ways {...props} received={received} shared={shared} />
    </>
  );
}

/** @param isKept whether the library has it: then not only this page shows it. */
function Head({ shared, isKept }: { readonly shared: SharedSetting; readonly isKept: boolean }) {
  const { received: words } = share;
  const { program, name, modelName, at } = shared;
  return (
    <div class="stack gap-1">
      <p class="received-name">
        <strong>{name}</strong> {apart(modelName)}
      </p>
      <p class="hint">{dotted([timerText(program), dateText(at)])}</p>
      {!isKept && <p class="hint">{words.lead}</p>}
    </div>
  );
}

type PlaceProps = Pick<ReceivedSettingProps, 'session'> & {
  readonly received: Received;
  readonly shared: SharedSetting;
};

/** Under which model it would be kept, or that it is kept already. */
function Place({ session, received, shared }: PlaceProps) {
  const { received: words } = share;
  const id = useId();
  const { library } = session;
  const known = received.known.value;
  return (
    <>
      {known && <p role="status">{words.known(nameOf(session, known.setting.model, known.setting.name))}</p>}
      <div class="received-place">
        <label for={id}>{words.modelChoice}</label>
        <select
          id={id}
          value={received.place.value}
          onChange={({ currentTarget }) => received.choosePlace(currentTarget.value)}
        >
          {shared.modelName && <option value={NEW_MODEL}>{words.newModel(shared.modelName)}</option>}
          <option value={NO_MODEL}>{messages.value.noModel}</option>
          {library.models.list.value
            .filter(({ model }) => !model.archived)
            .map(({ key, model }) => (
              <option key={key} value={key}>
                {model.name}
              </option>
            ))}
        </select>
      </div>
    </>
  );
}

function Values({ shared }: { readonly shared: SharedSetting }) {
  const { program: table, servoName } = messages.value;
  const { program, note, tags } = shared;
  return (
    <>
      <KeyFigures program={program} />
      <div class="received-lanes">
        <SmallLanes program={program} names={program.positions.map((_, servo) => servoName(servo))} />
      </div>
      {/* With many servos it scrolls, also by keyboard. */}
      <section class="received-table" tabindex={0} aria-label={table.tableCaption}>
        <TimesTable program={program} caption={table.tableCaption} />
      </section>
      {note !== '' && <p class="received-note">{note}</p>}
      {tags.length > 0 && <p class="hint">{tags.join(', ')}</p>}
    </>
  );
}

type WaysProps = ReceivedSettingProps & PlaceProps;

/** What the pilot can do with it. */
function Ways({ session, sharing, received, shared, onProgram, onLibrary }: WaysProps) {
  const { received: words } = share;
  const failed = useSignal(false);
  const { opened, library, editor } = session;
  const obstacle = opened.obstacle(shared.program);
  // Until then the models are not known, and one might be made twice.
  const isLoaded = library.models.loaded.value && library.settings.loaded.value;
  const kept = received.kept.value;
  const open = async (): Promise<void> => {
    const setting = received.setting();
    failed.value = !setting || !(await session.opened.show(setting));
    if (failed.peek()) return;
    sharing.close();
    onProgram();
  };
  return (
    <>
      {obstacle !== null && <p class="hint">{obstacleText(obstacle)}</p>}
      {obstacle === null && editor.dirty.value && <p class="hint">{words.unwritten}</p>}
      <Problem text={failed.value && libraryMessages.setting.notShown} />
      <div class="buttons received-ways">
        {kept && (
          <p class={kept.isSaved ? 'received-kept' : 'received-kept bad-text'} role="status">
            {kept.isSaved ? words.kept(shared.name) : messages.value.notKept}
          </p>
        )}
        <button type="button" class="quiet" onClick={() => sharing.close()}>
          {kept ? messages.value.close : words.discard}
        </button>
        <button type="button" disabled={obstacle !== null} onClick={() => void open()}>
          {messages.value.open}
        </button>
        {kept ? (
          <button
            type="button"
            class="primary"
            onClick={() => {
              sharing.close();
              onLibrary(kept.setting.model, kept.setting.id);
            }}
          >
            {words.show}
          </button>
        ) : (
          <button
            type="button"
            class="primary"
            disabled={received.keeping.value || !isLoaded}
            onClick={() => void received.keep()}
          >
            {words.keep}
          </button>
        )}
      </div>
    </>
  );
}

function nameOf({ library }: Session, model: string | null, name: string): string {
  return dotted([library.models.get(model)?.model.name, name]);
}
