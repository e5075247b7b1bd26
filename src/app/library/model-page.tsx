import { LIMITS, type Model } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { plainName } from '../records/plain-names.js';
import type { ModelRecord } from '../storage/index.js';
import type { Session } from '../work/session.js';
import { ClassChoice } from './class-choice.js';
import { ModelServos } from './model-servos.js';
import type { Places } from './places.js';
import { TextField } from './text-field.js';

interface ModelPageProps {
  readonly session: Session;
  readonly places: Places;
  readonly record: ModelRecord;
  /** The model was deleted: leaves its page. */
  readonly onGone: () => void;
}

/**
 * All facts about a model. They stand beside or below its settings, which show its name. Each change is saved at once.
 */
export function ModelPage({ session, places, record, onGone }: ModelPageProps) {
  const words = moreMessages.value.library;
  const { label } = messages.value;
  const { library } = session;
  const { model } = record;
  const change = (changed: Partial<Model>): void => void library.changeModel(record.key, changed);
  const settings = library.settings.list.value.filter(({ setting }) => setting.model === record.key);
  return (
    <div class="stack gap-4 model-page" key={record.key}>
      <div class="row between library-head">
        <h2>{words.model.facts}</h2>
        <div class="buttons">{places.modelButtons(record)}</div>
      </div>
      <TextField
        label={label.name}
        value={model.name}
        longest={LIMITS.name}
        required
        asKept={plainName}
        onSave={(name) => change({ name })}
      />
      <ClassChoice value={model.timerClass} onChange={(timerClass) => change({ timerClass })} />
      <TextField
        label={label.note}
        value={model.note}
        longest={LIMITS.note}
        lines={3}
        onSave={(note) => change({ note })}
      />
      <ModelServos session={session} record={record} onChange={(servos) => change({ servos })} />
      <div class="buttons">
        <button type="button" class="quiet" onClick={() => change({ archived: !model.archived })}>
          {model.archived ? words.model.unarchive : words.model.archive}
        </button>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            library.removeModel(record.key);
            onGone();
          }}
        >
          {words.model.remove}
        </button>
      </div>
      {settings.length > 0 && <p class="hint">{words.model.withSettings({ count: settings.length })}</p>}
    </div>
  );
}
