/** What of a key press says which letter it is. */
type Press = Pick<KeyboardEvent, 'key' | 'code' | 'ctrlKey' | 'metaKey' | 'altKey'>;

/**
 * The Latin letter that is pressed together with Ctrl or Cmd, in lower case; null for any other key. The letter is the
 * one that the key types. Only where it types a letter of another script, as on a Greek keyboard, the place of the key
 * counts: a Latin keyboard with its letters elsewhere keeps them there.
 */
export function shortcutLetter({ key, code, ctrlKey, metaKey, altKey }: Press): string | null {
  // AltGr comes as Ctrl with Alt.
  if (!(ctrlKey || metaKey) || altKey) return null;
  if (/^[a-z]$/i.test(key)) return key.toLowerCase();
  const isOfAnotherScript = /^(?!\p{Script=Latin})[\p{Letter}\p{Mark}]$/u.test(key);
  return (isOfAnotherScript && /^Key([A-Z])$/.exec(code)?.[1]?.toLowerCase()) || null;
}
