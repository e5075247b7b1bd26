import { useCallback, useRef } from 'preact/hooks';
import { dotted } from '../messages/dotted.js';
import { libraryMessages } from '../messages/en-library.js';
import { dateText } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import type { Session } from '../session/session.js';
import type { SettingRecord } from '../storage/index.js';
import { memo } from '../ui/memo.js';
import { useNear } from '../ui/use-near.js';
import { Arrange } from './arrange.js';
import type { Browse } from './browse.js';
import { addressOf } from './place.js';

interface SettingListProps {
  readonly session: Session;
  readonly browse: Browse;
  readonly records: readonly SettingRecord[];
  /** The id of the one that is chosen. */
  readonly chosen: string | null;
  /** Whether each setting names its model, because they are of many. */
  readonly withModel?: boolean;
  /** Whether the rows can be moved now. */
  readonly arranging?: boolean;
}

/** Settings, one in a row. Of a long list only the rows nearby are drawn. */
export function SettingList({ session, browse, records, chosen, withModel, arranging = false }: SettingListProps) {
  const { settings, models } = session.library;
  const room = browse.room.value;
  const open = session.origin.setting.value?.id ?? null;
  const refused = settings.refused.value;
  return (
    <>
      <Arrange
        on={arranging}
        class="library-list library-settings"
        items={arranging ? records : records.slice(0, room)}
        nameOf={({ setting }) => setting.name}
        onMove={(keys) => void session.library.arrange(settings, keys)}
      >
        {(record) => (
          <SettingRow
            record={record}
            address={addressOf(models.get(record.setting.model)?.key ?? null, record.key)}
            model={withModel ? (models.get(record.setting.model)?.model.name ?? '') : ''}
            isChosen={chosen === record.key}
            isOpen={open === record.key}
            isKept={!refused.has(record.key)}
          />
        )}
      </Arrange>
      {!arranging && records.length > room && <More key={room} browse={browse} left={records.length - room} />}
    </>
  );
}

interface SettingRowProps {
  readonly record: SettingRecord;
  readonly address: string;
  readonly model: string;
  readonly isChosen: boolean;
  readonly isOpen: boolean;
  readonly isKept: boolean;
}

const SettingRow = memo(SettingRowContent);

function SettingRowContent({ record, address, model, isChosen, isOpen, isKept }: SettingRowProps) {
  const words = libraryMessages;
  const { name, at, tags, archived, program } = record.setting;
  const [dt] = keyFigures(program);
  return (
    <a class="library-item" href={address} aria-current={isChosen ? 'true' : undefined}>
      <span class="library-line">
        <b>{name}</b>
        <span>{dt && `${dt.label} ${dt.text}`}</span>
      </span>
      <span>
        {dotted([
          model,
          isOpen && words.list.open,
          dateText(at),
          ...tags,
          archived && words.models.archived,
          !isKept && words.unkept.mark,
        ])}
      </span>
    </a>
  );
}

/** A button for the rest of a long list. It acts without a click when it comes near the window. */
function More({ browse, left }: { readonly browse: Browse; readonly left: number }) {
  const { list } = libraryMessages;
  const place = useRef<HTMLButtonElement>(null);
  const showMore = useCallback(() => browse.showMore(), [browse]);
  useNear(place, showMore, 1200);
  return (
    <button type="button" class="quiet" ref={place} onClick={showMore}>
      {list.more(left)}
    </button>
  );
}
