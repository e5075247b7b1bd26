import { useEffect } from 'preact/hooks';
import { CodecError } from '../../../protocol/index.js';
import { takeOpenedFiles } from '../../browser/dropped-files.js';
import { apart } from '../../messages/apart.js';
import { dateText, messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { countedText } from '../../messages/names.js';
import { Modal } from '../../ui/modal.js';
import { Problem } from '../../ui/problem.js';
import { countOf, type Group, takenOf } from './import-plan.js';
import type { AskedFile, LibraryFiles, Plan, Refusal } from './library-files.js';
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
    <Modal open title={isRefused ? refused.title({ name }) : words.title({ name })} onEscape={() => answer(false)}>
      {isReading && <p role="status">{parts.coming}</p>}
      {isRefused && <Refused {...shown} />}
      {isReading || isRefused ? (
        <div class="buttons">
          <button type="button" onClick={() => answer(false)}>
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
function Refused({ why }: Refusal) {
  const { refused: words } = moreMessages.value.files;
  const reason = reasonOf(why);
  const { line, wanted, value } = why instanceof CodecError ? why.details : {};
  const isTold = line !== undefined && wanted !== undefined;
  const damage = isTold ? words.fault({ line, found: shown(value) }) : words.damaged;
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
  const groups = plan.groups.value;
  const total = groups.reduce((sum, group) => sum + takenOf(group).length, 0);
  const isHere = groups.every(({ entries }) => entries.every(({ standing }) => standing === 'same'));
  const { shut } = files;
  const date = dateText(plan.writtenAt);
  const what = countedText(plan.holds);
  return (
    <>
      <p>{what === '' ? words.leadNothing({ date }) : words.lead({ date, what })}</p>
      {plan.ignored > 0 && <p class="hint">{words.ignored({ count: plan.ignored })}</p>}
      <ul class="stack import-groups">
        {groups.map((group) => (
          <GroupRow key={group.id} group={group} />
        ))}
      </ul>
      {total === 0 && what !== '' && <p role="status">{isHere ? words.nothing : words.take({ count: 0 })}</p>}
      <Problem text={shut && total > 0 && moreMessages.value.library.unread} />
      <div class="buttons">
        <button type="button" class={total === 0 ? '' : 'quiet'} onClick={() => answer(false)}>
          {total === 0 ? messages.value.close : messages.value.cancel}
        </button>
        {total > 0 && (
          <button
            type="button"
            class="primary"
            disabled={shut}
            onClick={() => {
              answer(true);
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
  const lines = [
    ['new', words.group.fresh],
    ['file-newer', words.group.fileNewer],
    ['not-newer', words.group.deviceNewer],
    ['same', words.group.same],
  ] as const;
  return (
    <li>
      <b>{group.name || (group.id === null ? messages.value.noModel : words.unknownModel)}</b>
      {lines.map(([standing, line]) => {
        const what = countedText(countOf(group.entries.filter((entry) => entry.standing === standing)));
        return what !== '' && <span key={standing}>{line({ what })}</span>;
      })}
    </li>
  );
}
