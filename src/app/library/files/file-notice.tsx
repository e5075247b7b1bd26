import { filesMessages } from '../../messages/en-files.js';
import { libraryMessages } from '../../messages/en-library.js';
import { messages } from '../../messages/index.js';
import type { FileWord, LibraryFiles } from './library-files.js';

const BAD: ReadonlySet<FileWord['kind']> = new Set(['partly', 'too-large', 'unread', 'failed']);

/** What was last done with files, with a button to undo an import. */
export function FileNotice({ files }: { readonly files: LibraryFiles }) {
  const { import: words } = filesMessages;
  const said = files.said.value;
  if (!said) return null;
  const isBad = BAD.has(said.kind) || ('kept' in said && !said.kept);
  return (
    <div class={isBad ? 'notice bad' : 'notice'}>
      <p>{wordText(said)}</p>
      {said.kind === 'imported' && (
        <button type="button" onClick={() => void files.undo()}>
          {words.undo}
        </button>
      )}
      {said.kind !== 'busy' && (
        <button type="button" class="quiet" onClick={() => files.dismissWord()}>
          {messages.value.dismiss}
        </button>
      )}
    </div>
  );
}

function wordText(said: FileWord): string {
  const { export: out, import: into } = filesMessages;
  const { counted, parts, notKept } = messages.value;
  switch (said.kind) {
    case 'busy':
      return parts.coming;
    case 'downloaded':
      return out.downloaded(said.name, counted(said.holds));
    case 'partly':
      return out.partly(said.name, counted(said.holds), said.missing);
    case 'unread':
      return libraryMessages.unread;
    case 'too-large':
      return out.tooLarge;
    case 'failed':
      return out.failed;
    case 'imported':
      return [into.done(counted(said.holds), said.name), !said.kept && notKept].filter(Boolean).join(' ');
    case 'undone':
      return said.kept ? into.undone : notKept;
  }
}
