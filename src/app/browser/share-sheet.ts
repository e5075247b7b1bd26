import { nameplate, service } from './services.js';

/** Whether the system can hand a link to other programs and to people. */
export function canSend(): boolean {
  return service('share') !== null;
}

/**
 * Opens the system's sheet of whom to share with. That may take as long as the pilot does.
 * @returns false where the system refuses; a pilot who closes the sheet has his way.
 */
export async function send(what: { readonly title: string; readonly url: string }): Promise<boolean> {
  try {
    await service('share')?.call(nameplate() as Navigator, what);
    return true;
  } catch (cause) {
    return cause instanceof DOMException && cause.name === 'AbortError';
  }
}
