import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import type { LibraryFiles } from './library-files.js';

/** What was last done with files, with a button to undo an import. */
export function FileNotice({ files }: { readonly files: LibraryFiles }) {
  const said = files.said.value;
  if (!said) return null;
  return (
    <div class={said.isBad ? 'notice bad' : 'notice'}>
      <p>{said.text()}</p>
      {said.undo && (
        <button type="button" onClick={said.undo}>
          {moreMessages.value.files.import.undo}
        </button>
      )}
      {!said.isBusy && (
        <button type="button" class="quiet" onClick={() => files.dismissWord()}>
          {messages.value.dismiss}
        </button>
      )}
    </div>
  );
}
