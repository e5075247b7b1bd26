import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { timerName } from '../messages/names.js';
import type { ModelRecord } from '../storage/index.js';
import { BackHead } from '../ui/back-head.js';
import type { Session } from '../work/session.js';
import type { Browse } from './browse.js';
import { NewSetting } from './new-setting.js';
import type { Places } from './places.js';
import { SettingList } from './setting-list.js';

interface ModelColumnProps {
  readonly session: Session;
  readonly browse: Browse;
  readonly places: Places;
  /** Null when it is not in the library, or for the settings of no model. */
  readonly model: ModelRecord | null;
  readonly isLoose: boolean;
  /** The id of the setting that is chosen. */
  readonly chosen: string | null;
  readonly onGo: (path: string) => void;
  /** What belongs to the model and has no other place. */
  readonly children?: ComponentChildren;
}

/** One model with its settings. */
export function ModelColumn(props: ModelColumnProps) {
  const { session, browse, places, model, isLoose, chosen, onGo, children } = props;
  const words = moreMessages.value.library;
  const making = useSignal(false);
  const records = browse.byModel.value.get(model?.key ?? null) ?? [];
  const name = model?.model.name ?? messages.value.noModel;
  return (
    <section class="stack gap-3" aria-label={name}>
      <BackHead back={words.models.all} to="#library" />
      {!model && !isLoose ? (
        !session.library.unread.value && <p class="hint">{words.setting.gone}</p>
      ) : (
        <>
          <div class="row">
            <h1>{name}</h1>
            {model && model.model.timerClass !== null && (
              <p class="hint">{timerName({ timerClass: model.model.timerClass })}</p>
            )}
          </div>
          {records.length === 0 && <p class="hint">{words.model.noSettings}</p>}
          <SettingList {...{ session, records, chosen }} />
          <div class="buttons">
            <button type="button" onClick={() => (making.value = true)}>
              {messages.value.newProgram.title}
            </button>
          </div>
          {model && places.modelSections(model)}
          {children}
        </>
      )}
      <NewSetting
        open={making.value}
        session={session}
        model={model}
        onClose={() => (making.value = false)}
        onMade={onGo}
      />
    </section>
  );
}
