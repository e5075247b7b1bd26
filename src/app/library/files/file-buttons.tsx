import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import type { LibraryFiles } from './library-files.js';
import './file-buttons.css';

/** The file of the whole library, and the reminder that an export is due. */
export function LibraryFileButtons({ files }: { readonly files: LibraryFiles }) {
  const words = moreMessages.value.files;
  return (
    <>
      <button type="button" onClick={() => files.choose()}>
        {words.import.button}
      </button>
      <button type="button" disabled={files.isEmpty} onClick={() => void files.export()}>
        {words.export.all}
      </button>
      <ExportReminder files={files} />
    </>
  );
}

/** The reminder that an export is due. Shown once, then not for a while. */
function ExportReminder({ files }: { readonly files: LibraryFiles }) {
  const due = files.marks.due.value;
  if (due === null) return null;
  return (
    <div class="row between export-reminder">
      <p>{moreMessages.value.files.reminder({ changes: due })}</p>
      <button type="button" class="quiet" onClick={() => files.marks.putOff()}>
        {messages.value.notNow}
      </button>
    </div>
  );
}
