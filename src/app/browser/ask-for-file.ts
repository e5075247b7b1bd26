/**
 * Asks the pilot for files to read, in a window of the browser. Only at a press of a key or a button.
 * @param accept the endings and types that are shown at first.
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
  // Safari forgets one that stands nowhere.
  document.body.append(field);
  field.click();
}
