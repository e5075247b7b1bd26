import { dotted } from '../messages/dotted.js';
import { dateText } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import type { SettingRecord } from '../storage/index.js';
import { memo } from '../ui/memo.js';
import type { Session } from '../work/session.js';
import { addressOf } from './place.js';

interface SettingListProps {
  readonly session: Session;
  readonly records: readonly SettingRecord[];
  /** The id of the one that is chosen. */
  readonly chosen: string | null;
  /** Whether each setting names its model, because they are of many. */
  readonly withModel?: boolean;
}

/** Settings, one in a row. */
export function SettingList({ session, records, chosen, withModel }: SettingListProps) {
  const { models } = session.library;
  const open = session.origin.setting.value?.id ?? null;
  return (
    <ul class="ruled library-list library-settings">
      {records.map((record) => (
        <li key={record.key}>
          <SettingRow
            record={record}
            address={addressOf(models.get(record.setting.model)?.key ?? null, record.key)}
            model={withModel ? (models.get(record.setting.model)?.model.name ?? '') : ''}
            isChosen={chosen === record.key}
            isOpen={open === record.key}
          />
        </li>
      ))}
    </ul>
  );
}

interface SettingRowProps {
  readonly record: SettingRecord;
  readonly address: string;
  readonly model: string;
  readonly isChosen: boolean;
  readonly isOpen: boolean;
}

const SettingRow = memo(SettingRowContent);

function SettingRowContent({ record, address, model, isChosen, isOpen }: SettingRowProps) {
  const words = moreMessages.value.library;
  const { name, at, tags, program } = record.setting;
  const [dt] = keyFigures(program);
  return (
    <a class="stack library-item" href={address} aria-current={isChosen ? 'true' : undefined}>
      <span class="library-line">
        <b>{name}</b>
        <span>{dt && `${dt.label} ${dt.text}`}</span>
      </span>
      <small>{dotted([model, isOpen && words.list.open, dateText(at), ...tags])}</small>
    </a>
  );
}
