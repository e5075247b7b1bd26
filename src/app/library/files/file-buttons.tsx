import { filesMessages } from '../../messages/en-files.js';
import { ALL_NAME, type LibraryFiles } from './library-files.js';
import type { FilePart } from './library-text.js';
import './file-buttons.css';

interface ExportButtonProps {
  readonly files: LibraryFiles;
  readonly part: FilePart;
  /** The name of the file, before its date. */
  readonly title: string;
}

/** Saves a part of the library to a file. After the first time: to the same file, or to another one. */
export function ExportButton({ files, part, title }: ExportButtonProps) {
  const { export: words } = filesMessages;
  const chosen = files.chosen(part);
  return (
    <>
      <button type="button" onClick={() => void files.export(part, title)}>
        {chosen ? words.again(chosen.name) : part.kind === 'all' ? words.all : words.one}
      </button>
      {chosen && (
        <button type="button" class="quiet" onClick={() => void files.export(part, title, true)}>
          {words.another}
        </button>
      )}
    </>
  );
}

/** The file of the whole library, and the reminder that an export is due. */
export function LibraryFileButtons({ files }: { readonly files: LibraryFiles }) {
  const words = filesMessages;
  return (
    <>
      <button type="button" onClick={() => files.ask()}>
        {words.import.button}
      </button>
      <ExportButton files={files} part={ALL} title={ALL_NAME} />
      <ExportReminder files={files} />
    </>
  );
}

const ALL: FilePart = { kind: 'all' };

/** The reminder that an export is due. Shown once, then not for a while. */
function ExportReminder({ files }: { readonly files: LibraryFiles }) {
  const { reminder: words } = filesMessages;
  const due = files.marks.due.value;
  if (!due) return null;
  return (
    <div class="export-reminder">
      <p>{due.days === null ? words.never(due.changes) : words.text(due.changes, due.days)}</p>
      <button type="button" class="quiet" onClick={() => files.marks.putOff()}>
        {words.later}
      </button>
    </div>
  );
}
