import { libraryMessages } from '../messages/en-library.js';
import { dayText } from '../messages/index.js';
import type { Library, LibraryClash } from '../session/library.js';
import { Modal } from '../ui/modal.js';
import './clash-dialog.css';

/** Two tabs have saved different things in the same place at nearly the same time. The pilot chooses one. */
export function ClashDialog({ library }: { readonly library: Library }) {
  const { clash: words } = libraryMessages;
  const clash = library.clash.value;
  const settle = (choice: 'mine' | 'theirs'): void => void (clash && library[clash.kind].settle(choice));
  return (
    <Modal open={clash !== null} title={words.title} held onEscape={() => {}}>
      {clash && (
        <>
          <p>{words.lead(nameOf(clash))}</p>
          <dl class="clash">
            {clash.disagreed.map((field) => (
              <Disagreed key={field} field={field} theirs={fieldsOf(clash.theirs)} mine={fieldsOf(clash.record)} />
            ))}
          </dl>
          <div class="buttons">
            <button type="button" onClick={() => settle('mine')}>
              {words.keepMine}
            </button>
            <button type="button" class="primary" onClick={() => settle('theirs')}>
              {words.keepTheirs}
            </button>
          </div>
        </>
      )}
    </Modal>
  );
}

/** Fields that are shown as they were typed. */
const READ: readonly string[] = [
  ...['name', 'note', 'tags', 'memoryNames'],
  ...['place', 'round', 'result', 'wind', 'temperature', 'modelName', 'settingName'],
];

type Fields = Readonly<Record<string, unknown>>;

interface DisagreedProps {
  readonly field: string;
  readonly theirs: Fields;
  readonly mine: Fields;
}

/** Shows values that can be read at a glance. Of all others it only says that they differ. */
function Disagreed({ field, theirs, mine }: DisagreedProps) {
  const { clash: words } = libraryMessages;
  const [there, here] = [theirs[field], mine[field]].map((value) => [value ?? '–'].flat().join(', '));
  return (
    <div>
      <dt>{words.field(field)}</dt>
      {READ.includes(field) && (
        <>
          <dd>
            <span class="hint">{words.theirs}</span> {there}
          </dd>
          <dd>
            <span class="hint">{words.mine}</span> {here}
          </dd>
        </>
      )}
    </div>
  );
}

function fieldsOf(record: LibraryClash['theirs']): Fields {
  const inner = 'model' in record ? record.model : 'setting' in record ? record.setting : record.flight;
  return inner as unknown as Fields;
}

function nameOf({ theirs }: LibraryClash): string {
  if ('model' in theirs) return theirs.model.name;
  if ('setting' in theirs) return theirs.setting.name;
  return libraryMessages.clash.flightOf(theirs.flight.modelName, dayText(theirs.flight.at));
}
