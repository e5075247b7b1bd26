import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { CodecError } from '../../../protocol/index.js';
import { takeOpenedFiles } from '../../browser/dropped-files.js';
import { apart } from '../../messages/apart.js';
import { dateText, dayText, messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { countedText } from '../../messages/names.js';
import { Modal } from '../../ui/modal.js';
import { Problem } from '../../ui/problem.js';
import { SegmentChoice } from '../../ui/segment-choice.js';
import { countOf, differs, type Entry, type Group, takenOf, WAYS, type Way } from './import-plan.js';
import type { AskedFile, LibraryFiles, Plan, Refusal } from './library-files.js';
import { faultText } from './place-in-file.js';
import './import-dialog.css';

interface ImportDialogProps {
  readonly files: LibraryFiles;
  /** Shows what has come into the library. */
  readonly onTaken: () => void;
}

/** What a file holds and what it would change in the library. Asks the pilot. */
export function ImportDialog({ files, onTaken }: ImportDialogProps) {
  const { refused, import: words } = moreMessages.value.files;
  const { cancel, close, parts } = messages.value;
  useEffect(() => takeOpenedFiles((opened) => void files.import(opened)), [files]);
  const asked = files.asked.value;
  if (!asked) return null;
  const { name, shown, answer } = asked;
  const isReading = shown === 'reading';
  const isRefused = !isReading && 'why' in shown;
  return (
    <Modal open title={isRefused ? refused.title({ name }) : words.title({ name })} onEscape={() => answer(null)}>
      {isReading && <p role="status">{parts.coming}</p>}
      {isRefused && <Refused {...shown} />}
      {isReading || isRefused ? (
        <div class="buttons">
          <button type="button" onClick={() => answer(null)}>
            {isReading ? cancel : close}
          </button>
        </div>
      ) : (
        <PlanOf {...{ files, onTaken, answer }} plan={shown} />
      )}
    </Modal>
  );
}

/** Why a file was refused, and where in it the fault stands. */
function Refused({ why, place }: Refusal) {
  const { refused: words } = moreMessages.value.files;
  const reason = reasonOf(why);
  const { line, wanted, value } = why instanceof CodecError ? why.details : {};
  const isTold = line !== undefined && wanted !== undefined;
  const damage = isTold ? faultText({ line, found: shown(value) }, place) : words.damaged;
  return (
    <>
      <p class="import-reason" role="alert">
        {reason ?? damage}
      </p>
      {reason === null && isTold && (
        <p>
          {words.wanted} <q lang="en">{wanted}</q>
        </p>
      )}
      <p>
        {words.nothing} {reason === null && words.again}
      </p>
    </>
  );
}

/** @returns null for a damaged library file, which another try may bring whole. */
function reasonOf(why: Refusal['why']): string | null {
  const { refused: words } = moreMessages.value.files;
  if (!(why instanceof CodecError)) return why === 'no-text' ? null : words.files[why];
  if (why.code === 'newer-version') return words.newer;
  if (why.code === 'too-large') return words.files['too-large'];
  return why.field === 'format' ? words.format : null;
}

/** How much of a value of the file is shown. */
const SHOWN = 40;

function shown(value: unknown): string {
  if (typeof value === 'object' && value !== null) return '{ }';
  const text = JSON.stringify(value) ?? '–';
  return apart(text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text);
}

interface PlanProps extends ImportDialogProps, Pick<AskedFile, 'answer'> {
  readonly plan: Plan;
}

function PlanOf({ files, onTaken, answer, plan }: PlanProps) {
  const { import: words } = moreMessages.value.files;
  const chosen = useSignal<Way>('newer');
  const groups = plan.groups.value;
  const way = chosen.value;
  const total = groups.reduce((sum, group) => sum + takenOf(group, way).length, 0);
  const isNothing = groups.every((group) => WAYS.every((each) => takenOf(group, each).length === 0));
  const { shut } = files;
  const date = dateText(plan.writtenAt);
  const what = countedText(plan.holds);
  return (
    <>
      <p>{what === '' ? words.leadNothing({ date }) : words.lead({ date, what })}</p>
      {plan.ignored > 0 && <p class="hint">{words.ignored({ count: plan.ignored })}</p>}
      {groups.some(({ entries }) => entries.some(differs)) && (
        <div class="stack">
          <SegmentChoice
            name="import-way"
            title={words.differs}
            choices={WAYS}
            names={words.ways}
            chosen={way}
            onChoose={(each) => (chosen.value = each)}
          />
          <p class="hint">{words.wayText[way]}</p>
        </div>
      )}
      <ul class="stack import-groups">
        {groups.map((group) => (
          <GroupRow key={group.id} group={group} />
        ))}
      </ul>
      {isNothing && groups.length > 0 && <p role="status">{words.nothing}</p>}
      {!isNothing && total === 0 && <p role="status">{way === 'newer' ? words.allStays : words.nothing}</p>}
      <Problem text={shut && !isNothing && moreMessages.value.library.unread} />
      <div class="buttons">
        <button type="button" class={isNothing ? '' : 'quiet'} onClick={() => answer(null)}>
          {isNothing ? messages.value.close : messages.value.cancel}
        </button>
        {!isNothing && (
          <button
            type="button"
            class="primary"
            disabled={total === 0 || shut}
            onClick={() => {
              answer(way);
              onTaken();
            }}
          >
            {words.take({ count: total })}
          </button>
        )}
      </div>
    </>
  );
}

/** What a file holds for one model. */
function GroupRow({ group }: { readonly group: Group }) {
  const { import: words } = moreMessages.value.files;
  const of = (standing: Entry['standing']): readonly Entry[] =>
    group.entries.filter((entry) => entry.standing === standing);
  const lines = [
    [countedText(countOf(of('new'))), words.group.fresh],
    [namesOf(of('file-newer')), words.group.fileNewer],
    [namesOf(of('not-newer')), words.group.deviceNewer],
    [countedText(countOf(of('same'))), words.group.same],
  ] as const;
  return (
    <li>
      <b>{group.name || (group.id === null ? messages.value.noModel : words.unknownModel)}</b>
      {lines.map(([what, line]) => what !== '' && <span key={line({ what })}>{line({ what })}</span>)}
    </li>
  );
}

/** How many entries are named. */
const NAMED = 3;

/** The names of the entries that differ. */
function namesOf(entries: readonly Entry[]): string {
  const { import: words } = moreMessages.value.files;
  const names = entries.slice(0, NAMED).map(({ kind, entry, here }) => {
    if (kind === 'models') return words.itself;
    if (!('name' in entry)) return words.flightOf({ day: dayText(entry.at) });
    const name = here && 'name' in here ? here.name : entry.name;
    return name === entry.name ? apart(name) : words.group.fileName({ here: name, file: entry.name });
  });
  const more = entries.length - names.length;
  return [names.join(', '), more > 0 && messages.value.more({ count: more })].filter(Boolean).join('. ');
}
