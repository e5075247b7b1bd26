import { useSignal } from '@preact/signals';
import { dotted } from '../messages/dotted.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { timerName } from '../messages/names.js';
import type { ModelRecord } from '../storage/index.js';
import type { Session } from '../work/session.js';
import type { Browse } from './browse.js';
import { EmptyWords } from './library-beginning.js';
import { NewModelDialog } from './new-model-dialog.js';
import { addressOf, NO_MODEL } from './place.js';
import type { Places } from './places.js';
import { SettingList } from './setting-list.js';

interface ModelListProps {
  readonly session: Session;
  readonly browse: Browse;
  readonly places: Places;
  /** Whether nothing stands beside it. */
  readonly alone: boolean;
  readonly onGo: (path: string) => void;
}

/** All models, or the settings that a search finds in all of them. */
export function ModelList({ session, browse, places, alone, onGo }: ModelListProps) {
  const words = moreMessages.value.library;
  const making = useSignal(false);
  const found = browse.found.value;
  const { library } = session;
  const archived = library.models.list.value.filter(({ model }) => model.archived).length;
  const isArchiveShown = browse.archive.value;
  const isEmpty = library.models.list.value.length + library.settings.list.value.length === 0;
  return (
    <section class="stack gap-3" aria-label={words.models.title}>
      <h1>{messages.value.views.names.library}</h1>
      <input
        type="search"
        aria-label={words.search.label}
        placeholder={messages.value.label.search}
        autocomplete="off"
        value={browse.text.value}
        onInput={(event) => browse.search(event.currentTarget.value)}
      />
      {found === null ? (
        <>
          {isEmpty && alone && !library.unread.value && <EmptyWords />}
          <Models browse={browse} />
          <div class="buttons">
            <button type="button" onClick={() => (making.value = true)}>
              {words.models.make}
            </button>
            {archived > 0 && (
              <button
                type="button"
                class="quiet"
                aria-expanded={isArchiveShown}
                onClick={() => browse.showArchive(!isArchiveShown)}
              >
                {words.models.archive({ count: archived })}
              </button>
            )}
          </div>
          <div class="stack gap-3 library-more">{places.library}</div>
        </>
      ) : (
        <>
          <p class="hint" role="status">
            {found.length === 0 ? words.search.nothing : words.models.settings({ count: found.length })}
          </p>
          <SettingList session={session} records={found} chosen={null} withModel />
        </>
      )}
      <NewModelDialog open={making.value} session={session} onClose={() => (making.value = false)} onMade={onGo} />
    </section>
  );
}

function Models({ browse }: Pick<ModelListProps, 'browse'>) {
  const words = moreMessages.value.library.models;
  const count = (model: string | null): number => browse.byModel.value.get(model)?.length ?? 0;
  const about = ({ key, model: { timerClass, archived } }: ModelRecord): string =>
    dotted([
      timerClass === null ? '' : timerName({ timerClass }),
      words.settings({ count: count(key) }),
      archived && words.archived,
    ]);
  return (
    <ul class="panel ruled library-list">
      {browse.models.value.map((record) => (
        <Row key={record.key} address={addressOf(record.key)} name={record.model.name} about={about(record)} />
      ))}
      {count(null) > 0 && (
        <Row
          key={NO_MODEL}
          address={addressOf(null)}
          name={messages.value.noModel}
          about={words.settings({ count: count(null) })}
        />
      )}
    </ul>
  );
}

function Row({ address, name, about }: Readonly<Record<'address' | 'name' | 'about', string>>) {
  return (
    <li>
      <a class="stack library-item" href={address}>
        <b>{name}</b>
        <small>{about}</small>
      </a>
    </li>
  );
}
