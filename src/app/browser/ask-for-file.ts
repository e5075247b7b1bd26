/**
 * Asks the pilot for files to read, in a window of the browser. Call it only from a click or a key press.
 * @param accept the file endings and types to offer.
 */
export function askForFiles(accept: string, onChosen: (files: readonly File[]) => void): void {
  const field = document.createElement('input');
  field.type = 'file';
  field.accept = accept;
  field.hidden = true;
  field.addEventListener('change', () => {
    field.remove();
    onChosen([...(field.files ?? [])]);
  });
  field.addEventListener('cancel', () => field.remove());
  // Safari forgets an input that is not in the document.
  document.body.append(field);
  field.click();
}
