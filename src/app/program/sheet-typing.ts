/** Types a text into a field as a keyboard would: replaces the selection, or inserts at the caret. */
export function typeInto(input: HTMLInputElement, text: string): void {
  const { selectionStart, selectionEnd, value } = input;
  replace(input, text, selectionStart ?? value.length, selectionEnd ?? value.length);
}

/** Deletes the selection, or the character before the caret. */
export function eraseLast(input: HTMLInputElement): void {
  const { value } = input;
  const end = input.selectionEnd ?? value.length;
  const start = input.selectionStart ?? end;
  replace(input, '', start < end ? start : Math.max(0, end - 1), end);
}

function replace(input: HTMLInputElement, text: string, start: number, end: number): void {
  input.setRangeText(text, start, end, 'end');
  input.dispatchEvent(new InputEvent('input', { bubbles: true, inputType: text ? 'insertText' : 'deleteContent' }));
}
