import { attempt, service } from './services.js';

/**
 * Copies a text.
 * @throws the error of the browser when it does not allow copying, or does not answer soon.
 */
export function copyText(text: string): Promise<void> {
  return attempt(async () => await here().writeText(text));
}

/**
 * Reads the clipboard. The browser may ask the pilot first, so this can take very long, or for ever.
 * @throws the error of the browser when it does not allow reading.
 */
export async function copiedText(): Promise<string> {
  return await here().readText();
}

function here(): Pick<Clipboard, 'readText' | 'writeText'> {
  const clipboard = service('clipboard');
  if (!clipboard) throw new Error('there is no clipboard');
  return clipboard;
}
