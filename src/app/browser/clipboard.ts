import { answerOf, service } from './services.js';

/**
 * Copies a text.
 * @throws what the browser says where it does not let this page copy, or has not said in a moment that it did.
 */
export function copyText(text: string): Promise<void> {
  return answerOf(async () => await here().writeText(text));
}

/**
 * What was copied last, anywhere. A browser may ask the pilot first: this can take as long as the pilot does, or for
 * ever.
 * @throws what the browser says where it does not let this page see it.
 */
export async function copiedText(): Promise<string> {
  return await here().readText();
}

function here(): Pick<Clipboard, 'readText' | 'writeText'> {
  const clipboard = service('clipboard');
  if (!clipboard) throw new Error('there is no clipboard');
  return clipboard;
}
