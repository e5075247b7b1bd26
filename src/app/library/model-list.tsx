import { useSignal } from '@preact/signals';
import { dotted } from '../messages/dotted.js';
import { libraryMessages } from '../messages/en-library.js';
import { messages, timerName } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { ModelRecord } from '../storage/index.js';
import { memo } from '../ui/memo.js';
import type { Browse } from './browse.js';
import { EmptyWords } from './empty-words.js';
import { NewModelDialog } from './new-model-dialog.js';
import { addressOf, NO_MODEL } from './place.js';
import type { Places } from './places.js';
import { SettingList } from './setting-list.js';

interface ModelListProps {
  readonly session: Session;
  readonly browse: Browse;
  /** The id of the chosen model, and of its setting. */
  readonly chosen: string | null;
  readonly setting: string | null;
  readonly places: Places;
  /** Whether nothing stands beside it. */
  readonly alone: boolean;
  /** Whether what a search finds stands beside it. */
  readonly foundBeside: boolean;
  readonly onGo: (path: string) => void;
}

/** All models, or the settings that a search finds in all of them. */
export function ModelList({ session, browse, chosen, setting, places, alone, foundBeside, onGo }: ModelListProps) {
  const words = libraryMessages;
  const making = useSignal(false);
  const found = browse.found.value;
  const { library } = session;
  const isEmpty = library.models.list.value.length + library.settings.list.value.length === 0;
  return (
    <section class="library-models" aria-label={words.models.title}>
      <h1>{messages.value.views.names.library}</h1>
      <input
        type="search"
        class="library-search"
        aria-label={words.search.label}
        placeholder={messages.value.label.search}
        autocomplete="off"
        value={browse.text.value}
        onInput={(event) => browse.search(event.currentTarget.value)}
      />
      {found === null || foundBeside ? (
        <>
          {isEmpty && alone && !library.unread.value && (
            <div class="stack library-empty">
              <EmptyWords />
            </div>
          )}
          <Models {...{ session, browse, chosen }} />
          <div class="buttons">
            <button type="button" onClick={() => (making.value = true)}>
              {words.models.make}
            </button>
            <ArchiveButton
              browse={browse}
              count={library.models.list.value.filter(({ model }) => model.archived).length}
            />
          </div>
          <div class="stack gap-3 library-more">{places.library}</div>
        </>
      ) : (
        <>
          <p class="hint" role="status">
            {foundText(found.length)}
          </p>
          <SettingList session={session} records={found} chosen={setting} withModel />
        </>
      )}
      <NewModelDialog open={making.value} session={session} onClose={() => (making.value = false)} onMade={onGo} />
    </section>
  );
}

/** “12 programs”, or that a search has found none. */
export function foundText(count: number): string {
  const { search, models } = libraryMessages;
  return count === 0 ? search.nothing : models.settings(count);
}

function Models({ session, browse, chosen }: Pick<ModelListProps, 'session' | 'browse' | 'chosen'>) {
  const words = libraryMessages;
  const models = browse.models.value;
  const loose = browse.byModel.value.get(null)?.length ?? 0;
  return (
    <ul class="library-list">
      {models.map((record) => (
        <li key={record.key}>
          <ModelRow
            record={record}
            count={browse.byModel.value.get(record.key)?.length ?? 0}
            isChosen={chosen === record.key}
            isKept={!session.library.models.refused.value.has(record.key)}
          />
        </li>
      ))}
      {loose > 0 && (
        <li key={NO_MODEL}>
          <a class="stack library-item" href={addressOf(null)} aria-current={chosen === NO_MODEL ? 'true' : undefined}>
            <b>{messages.value.noModel}</b>
            <span>{words.models.settings(loose)}</span>
          </a>
        </li>
      )}
    </ul>
  );
}

interface ModelRowProps {
  readonly record: ModelRecord;
  readonly count: number;
  readonly isChosen: boolean;
  readonly isKept: boolean;
}

const ModelRow = memo(ModelRowContent);

function ModelRowContent({ record, count, isChosen, isKept }: ModelRowProps) {
  const words = libraryMessages;
  const { name, timerClass, archived } = record.model;
  return (
    <a class="stack library-item" href={addressOf(record.key)} aria-current={isChosen ? 'true' : undefined}>
      <b>{name}</b>
      <span>
        {dotted([
          timerClass === null ? '' : timerName({ timerClass }),
          words.models.settings(count),
          archived && words.models.archived,
          !isKept && words.unkept.mark,
        ])}
      </span>
    </a>
  );
}

/** Shows or hides archived models, where there are any. */
function ArchiveButton({ browse, count }: { readonly browse: Browse; readonly count: number }) {
  const { models: words } = libraryMessages;
  if (count === 0) return null;
  const isShown = browse.archive.value;
  return (
    <button type="button" class="quiet" aria-expanded={isShown} onClick={() => browse.showArchive(!isShown)}>
      {isShown ? words.hideArchive : words.archive(count)}
    </button>
  );
}
