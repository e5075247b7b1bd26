import { filesMessages } from '../../messages/en-files.js';
import { messages } from '../../messages/index.js';
import type { FileWord, LibraryFiles } from './library-files.js';

const BAD: ReadonlySet<FileWord['kind']> = new Set(['not-written', 'partly', 'too-large', 'unread', 'failed']);

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
      {said.kind !== 'saving' && said.kind !== 'importing' && said.kind !== 'undoing' && (
        <button type="button" class="quiet" onClick={() => files.dismissWord()}>
          {messages.value.dismiss}
        </button>
      )}
    </div>
  );
}

function wordText(said: FileWord): string {
  const { export: out, import: into, counted } = filesMessages;
  switch (said.kind) {
    case 'saving':
      return out.saving(said.name);
    case 'importing':
      return into.importing(said.name, said.done, said.of);
    case 'undoing':
      return into.undoing(said.done, said.of);
    case 'saved':
      return out.saved(said.name, counted(said.holds));
    case 'downloaded':
      return out.downloaded(said.name, counted(said.holds));
    case 'partly':
      return out.partly(said.name, counted(said.holds), said.missing);
    case 'unread':
      return out.unread;
    case 'not-written':
      return out.notWritten(said.name);
    case 'too-large':
      return out.tooLarge;
    case 'nothing':
      return out.nothing;
    case 'failed':
      return out.failed;
    case 'imported':
      return [into.done(counted(said.holds), said.name), !said.kept && into.unkept].filter(Boolean).join(' ');
    case 'undone':
      return said.kept ? into.undone : into.undoUnkept;
    case 'partly-undone':
      return said.kept ? into.partlyUndone : into.undoUnkept;
  }
}
