/** Milliseconds that a browser may take to begin with a download. */
const BEGUN = 10_000;

/** Gives a text to the browser as a file to be saved. */
export function saveFile(name: string, text: string, type = 'text/plain'): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), BEGUN);
}
