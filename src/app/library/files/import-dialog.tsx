import { CodecError } from '../../../protocol/index.js';
import { apart } from '../../messages/apart.js';
import { filesMessages } from '../../messages/en-files.js';
import { dateText, dayText, messages } from '../../messages/index.js';
import { Select } from '../../ui/choice.js';
import { Modal } from '../../ui/modal.js';
import { Problem } from '../../ui/problem.js';
import { SegmentChoice } from '../../ui/segment-choice.js';
import { countOf, differs, type Entry, type Group, takenOf, WAYS, type Way } from './import-plan.js';
import type { FileRefusal, ImportStep, LibraryFiles } from './library-files.js';
import type { PlaceInFile } from './place-in-file.js';
import './import-dialog.css';

interface ImportDialogProps {
  readonly files: LibraryFiles;
  /** Shows what has come into the library. */
  readonly onTaken: () => void;
}

/** What a file holds and what it would change in the library. Asks the pilot. */
export function ImportDialog({ files, onTaken }: ImportDialogProps) {
  const words = filesMessages;
  const current = files.current.value;
  const name = current?.name ?? '';
  return (
    <Modal
      open={current !== null}
      title={current?.step === 'refused' ? words.refused.title(name) : words.import.title(name)}
      onEscape={() => files.dismiss()}
    >
      {current?.step === 'reading' && (
        <>
          <p role="status">{words.import.reading}</p>
          <CloseButton files={files} text={messages.value.cancel} />
        </>
      )}
      {current?.step === 'refused' && <Refused {...{ files }} why={current.why} place={current.place ?? null} />}
      {current?.step === 'plan' && <Plan {...{ files, onTaken }} step={current} />}
    </Modal>
  );
}

function CloseButton({ files, text }: { readonly files: LibraryFiles; readonly text: string }) {
  return (
    <div class="buttons">
      <button type="button" onClick={() => files.dismiss()}>
        {text}
      </button>
    </div>
  );
}

interface RefusedProps {
  readonly files: LibraryFiles;
  readonly why: FileRefusal;
  readonly place: PlaceInFile | null;
}

/** Why a file was refused, and where in it the fault stands. */
function Refused({ files, why, place }: RefusedProps) {
  const { refused: words } = filesMessages;
  return (
    <>
      <p role="alert">{why instanceof CodecError ? reasonOf(why) : words.files[why]}</p>
      {why instanceof CodecError && <Place why={why} place={place} />}
      <p>
        {words.nothing} {why instanceof CodecError && isDamaged(why) && words.again}
      </p>
      <CloseButton files={files} text={messages.value.close} />
    </>
  );
}

/** Whether it is a library file that another try may bring whole. */
function isDamaged({ code, field }: CodecError): boolean {
  return code !== 'newer-version' && code !== 'too-large' && field !== 'format' && field !== 'encoding';
}

/** The place as a pilot knows it, and where it stands in the text. */
function Place({ why, place }: { readonly why: CodecError; readonly place: PlaceInFile | null }) {
  const { refused: words } = filesMessages;
  const { line, column } = why.details;
  if (line === undefined || column === undefined || !isDamaged(why)) return null;
  return (
    <p class="hint import-place">
      {place && words.place(place)} {words.line(line, column)}
    </p>
  );
}

/** Fields with text, whose limits count characters. */
const TEXTS = /(?:name|note|place|round|writtenBy|tags\[\d+\]|memoryNames\[\d+\])$/i;
/** Inside the page a date is a number of milliseconds, which tells a person nothing. */
const DATES = /(?:^|\.)(?:at|\w+At)$/;

function reasonOf({ code, field, details: { min, max } }: CodecError): string {
  const { refused: words } = filesMessages;
  const reason = (code === 'bad-file' ? words.kinds[field] : words.codes[code]) ?? words.other;
  if (code !== 'out-of-range' || min === undefined || max === undefined || DATES.test(field)) return reason;
  if (max === Number.MAX_SAFE_INTEGER) return reason;
  return `${reason} ${TEXTS.test(field) ? words.characters(min, max) : words.between(min, max)}`;
}

interface PlanProps extends ImportDialogProps {
  readonly step: Extract<ImportStep, { step: 'plan' }>;
}

function Plan({ files, onTaken, step }: PlanProps) {
  const words = filesMessages;
  const groups = step.groups.value;
  const { all, of } = step.ways.value;
  const counts = groups.map((group) => takenOf(group, of.get(group.id) ?? all).length);
  const total = counts.reduce((sum, count) => sum + count, 0);
  const bringing = groups.filter((group) => takenOf(group, 'both').length > 0);
  const isNothing = bringing.length === 0;
  const differing = groups.filter(({ entries }) => entries.some(differs));
  const single = differing.length === 1 ? differing[0] : undefined;
  const isLeftOut = bringing.every(({ id }) => (of.get(id) ?? all) === 'skip');
  const { shut } = files;
  return (
    <>
      <p>
        {words.import.lead(dateText(step.writtenAt), step.writtenBy)} {words.import.holds(words.counted(step.holds))}
      </p>
      {step.ignored > 0 && <p class="hint">{words.import.ignored(step.ignored)}</p>}
      {differing.length > 1 && (
        <div class="import-ways">
          <SegmentChoice
            name="import-way"
            title={words.import.differs}
            choices={WAYS}
            names={words.import.ways}
            chosen={all}
            onChoose={(way) => files.choose(way)}
          />
          <p class="hint">{words.import.wayText[all]}</p>
        </div>
      )}
      <ul class="import-groups">
        {groups.map((group) => (
          <GroupRow key={group.id} {...{ files, group }} way={of.get(group.id) ?? all} />
        ))}
      </ul>
      {single && <p class="hint">{words.import.wayText[of.get(single.id) ?? all]}</p>}
      {isNothing && groups.length > 0 && <p role="status">{words.import.nothing}</p>}
      {!isNothing && total === 0 && <p role="status">{isLeftOut ? words.import.allLeftOut : words.import.allStays}</p>}
      <Problem text={shut && !isNothing && words.import.shut} />
      <div class="buttons">
        <button type="button" class={isNothing ? '' : 'quiet'} onClick={() => files.dismiss()}>
          {isNothing ? messages.value.close : messages.value.cancel}
        </button>
        {!isNothing && (
          <button
            type="button"
            class="primary"
            disabled={total === 0 || shut}
            onClick={() => {
              void files.take();
              onTaken();
            }}
          >
            {words.import.take(total)}
          </button>
        )}
      </div>
    </>
  );
}

interface GroupRowProps {
  readonly files: LibraryFiles;
  readonly group: Group;
  readonly way: Way;
}

/** What a file holds for one model, and what to do with it. */
function GroupRow({ files, group, way }: GroupRowProps) {
  const { import: words, counted } = filesMessages;
  const name = group.name || (group.id === null ? words.loose : words.unknownModel);
  const of = (standing: Entry['standing']): readonly Entry[] =>
    group.entries.filter((entry) => entry.standing === standing);
  const isDiffering = group.entries.some(differs);
  const hasNewer = of('file-newer').length + of('device-newer').length > 0;
  const lines = [
    [counted(countOf(of('new'))), words.group.fresh],
    [namesOf(of('file-newer'), words.group.fileName), words.group.fileNewer],
    [namesOf(of('device-newer'), words.group.hereName), words.group.deviceNewer],
    [namesOf(of('same-date'), words.group.hereName), words.group.sameDate],
    [counted(countOf(of('same'))), words.group.same],
  ] as const;
  const ways: readonly Way[] = isDiffering ? WAYS : WAYS.filter((each) => each !== 'both');
  const newer = hasNewer ? words.ways.newer : isDiffering ? words.keep : words.bring;
  return (
    <li class={way === 'skip' ? 'import-skipped' : undefined}>
      <div>
        <b>{name}</b>
        {lines.map(([what, line]) => what !== '' && <span key={line(what)}>{line(what)}</span>)}
      </div>
      {takenOf(group, 'both').length > 0 && (
        <Select
          name={words.group.way(name)}
          choices={ways}
          nameOf={(each) => (each === 'newer' ? newer : words.ways[each])}
          chosen={ways.includes(way) ? way : 'newer'}
          onChoose={(each) => files.choose(each, group)}
        />
      )}
    </li>
  );
}

/** How many entries are named. */
const NAMED = 3;

/** The names of the entries that differ. @param named both names of one, here and in the file, if they differ. */
function namesOf(entries: readonly Entry[], named: (here: string, file: string) => string): string {
  const { import: words } = filesMessages;
  const names = entries.slice(0, NAMED).map(({ kind, entry, here }) => {
    if (kind === 'models') return words.itself;
    if (!('name' in entry)) return words.flightOf(dayText(entry.at));
    const name = here && 'name' in here ? here.name : entry.name;
    return name === entry.name ? apart(name) : named(name, entry.name);
  });
  const more = entries.length - names.length;
  return [...names, ...(more > 0 ? [words.more(more)] : [])].join(', ');
}
