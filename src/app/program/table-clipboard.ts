import { copiedText } from '../browser/clipboard.js';
import { attempt } from '../browser/services.js';
import { formatTable } from '../editing/clipboard-table.js';
import type { Editor } from '../editing/editor.js';
import { messages } from '../messages/index.js';
import type { Pasting } from './paste-dialog.js';
import type { Selection } from './selection.js';

interface ClipboardUser {
  readonly editor: Editor;
  readonly selection: Selection;
  /** Called with what to paste. The pilot looks at it first. */
  readonly onPaste: (pasting: Pasting) => void;
  /** Called with the reason why nothing is pasted; with null once that is over. */
  readonly onObstacle: (text: string | null) => void;
}

/** Exchanges the table's cells with other programs, by keyboard events or by buttons. */
export function tableClipboard({ editor, selection, onPaste, onObstacle }: ClipboardUser) {
  const selectedText = (): string => {
    const { working } = editor;
    const range = selection.range.value;
    return range && working.value ? formatTable(working.value, range) : '';
  };
  const copy = (event: ClipboardEvent): void => {
    if (!selection.isWide.value || !event.clipboardData) return;
    event.preventDefault();
    event.clipboardData.setData('text/plain', selectedText());
  };
  /** No cell of a program can be empty, so Cut only copies, except for a part of a text. */
  const cut = (event: ClipboardEvent): void => {
    copy(event);
    const { target, clipboardData } = event;
    if (event.defaultPrevented || !(target instanceof HTMLInputElement) || !clipboardData) return;
    if (target.selectionStart !== 0 || target.selectionEnd !== target.value.length) return;
    event.preventDefault();
    clipboardData.setData('text/plain', target.value);
  };
  const paste = (event: ClipboardEvent): void => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const range = selection.range.value;
    if (!range || text === '') return;
    onObstacle(null);
    if (text.trim() === '') {
      // Empty cells: typed into the field, they would only empty it.
      event.preventDefault();
      onObstacle(messages.value.edits.table.range.clipboardClosed);
      return;
    }
    // One value into one cell counts as typing.
    if (!(selection.isWide.value || /[\t\r\n;]./.test(text))) return;
    event.preventDefault();
    onPaste({ range, text });
  };
  const pasteCopied = async (): Promise<void> => {
    const range = selection.range.value;
    const words = messages.value.edits.table.range;
    onObstacle(null);
    const asked = copiedText().then((text) => {
      onObstacle(range && text !== '' ? null : words.clipboardClosed);
      if (range && text !== '') onPaste({ range, text });
    });
    // The browser may be asking the pilot; an answer that comes later is welcome, too.
    await attempt(() => asked).catch(() => onObstacle(words.clipboardClosed));
  };
  return { selectedText, copy, cut, paste, pasteCopied };
}
