import { LIMITS, type Setting } from '../../program/index.js';
import { clockText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName, servoText, timerText } from '../messages/names.js';
import { plainName } from '../records/plain-names.js';
import type { SettingRecord } from '../storage/index.js';
import { BackHead } from '../ui/back-head.js';
import { Choice } from '../ui/choice.js';
import { OpenButton } from '../ui/open-button.js';
import type { Session } from '../work/session.js';
import { addressOf, addressPath, NO_MODEL } from './place.js';
import type { Places } from './places.js';
import { ProgramFacts } from './program-facts.js';
import { asTags, tagsText } from './tags.js';
import { TextField } from './text-field.js';
import './setting-page.css';

interface SettingPageProps {
  readonly session: Session;
  readonly places: Places;
  /** Null when it is not in the library. */
  readonly setting: SettingRecord | null;
  /** The model in the address, for a way back where its settings are not in sight. */
  readonly back: string | null;
  /** Shows the program that was opened. */
  readonly onProgram: () => void;
  readonly onGo: (path: string) => void;
}

/** One setting: its picture and figures, its notes, and what can be done with it. */
export function SettingPage(props: SettingPageProps) {
  const { session, places, setting: record, back, onGo } = props;
  const words = moreMessages.value.library;
  const { label, noModel } = messages.value;
  const { library } = session;
  const way = back !== null && (
    <BackHead
      back={back === NO_MODEL ? noModel : (library.models.get(back)?.model.name ?? words.models.all)}
      to={addressOf(back)}
    />
  );
  if (!record) {
    return (
      <>
        {way}
        {!library.unread.value && <p class="hint">{words.setting.gone}</p>}
      </>
    );
  }
  const { setting } = record;
  // With a way back, the list with the heading of the page is not beside it.
  const Heading = back !== null ? 'h1' : 'h2';
  const model = library.models.get(setting.model) ?? null;
  const names = setting.program.positions.map((_, servo) => servoText(servo, model?.model.servos[servo]));
  const change = (changed: Partial<Setting>): void => {
    // As it is now: a field saves its text late, perhaps when the setting was deleted.
    const now = library.settings.get(record.key)?.setting;
    if (now) void library.keepSetting({ ...now, ...changed });
  };
  return (
    <article class="stack gap-3 setting-page" aria-label={setting.name}>
      {way}
      <Heading class="setting-title">{setting.name}</Heading>
      <TextField
        label={label.note}
        value={setting.note}
        longest={LIMITS.note}
        lines={2}
        onSave={(note) => change({ note })}
      />
      <ProgramFacts program={setting.program} names={names}>
        <div class="buttons">
          <OpenSetting {...props} record={record} />
          {places.settingButtons(record, model)}
        </div>
      </ProgramFacts>
      {places.settingSections(record, model)}
      <TextField
        label={label.name}
        value={setting.name}
        longest={LIMITS.name}
        required
        asKept={plainName}
        onSave={(name) => change({ name })}
      />
      <TextField
        label={words.setting.tags}
        value={tagsText(setting.tags)}
        longest={LIMITS.tags * (LIMITS.tag + 2)}
        asKept={(text) => tagsText(asTags(plainName(text)))}
        onSave={(text) => change({ tags: asTags(text) })}
      />
      <Choice
        label={label.model}
        choices={[null, ...library.models.list.value.map(({ key }) => key)]}
        nameOf={(key) => library.models.get(key)?.model.name ?? noModel}
        chosen={model?.key ?? null}
        onChoose={(to) => {
          change({ model: to });
          onGo(addressPath(to, record.key));
        }}
      />
      <p class="hint sentence">
        {words.setting.origin({ source: words.setting.from[setting.from], time: clockText(setting.at) })}
        {'. '}
        {timerText(setting.program.identity)}
        {setting.program.memory !== null && `, ${memoryName(setting.program.memory)}`}
      </p>
      <div class="buttons">
        <button
          type="button"
          class="quiet"
          onClick={() => {
            library.settings.remove(record.key);
            onGo(addressPath(model?.key ?? null));
          }}
        >
          {messages.value.delete}
        </button>
      </div>
    </article>
  );
}

function OpenSetting({ session, record, onProgram }: SettingPageProps & { readonly record: SettingRecord }) {
  const words = moreMessages.value.library;
  const { opened } = session;
  const isOpen = session.origin.setting.value?.id === record.key;
  const obstacle = opened.obstacle(record.setting.program);
  const unsaved = isOpen ? opened.unsaved.value : null;
  const count = (unsaved?.changes ?? 0) + (unsaved?.unreadable ?? 0);
  if (isOpen) {
    return (
      <>
        <button type="button" class="primary" onClick={onProgram}>
          {words.setting.isOpen}
        </button>
        {count > 0 && Number.isFinite(count) && (
          <button
            type="button"
            disabled={obstacle !== null}
            onClick={() => {
              opened.loadAgain();
              onProgram();
            }}
          >
            {words.setting.loadAgain({ count })}
          </button>
        )}
        {count > 0 && <p class="hint whole-line">{words.save.state({ name: record.setting.name, changes: count })}</p>}
      </>
    );
  }
  return (
    <OpenButton
      label={messages.value.open}
      obstacle={obstacle}
      primary
      open={() => opened.show(record.setting)}
      onProgram={onProgram}
    />
  );
}
