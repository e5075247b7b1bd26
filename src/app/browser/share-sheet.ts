import { nameplate, service } from './services.js';

/** Whether the system can hand a link to other programs and people. */
export function canSend(): boolean {
  return service('share') !== null;
}

/**
 * Opens the system's sheet for sharing. That takes as long as the pilot does.
 * @returns false when the system refuses; true also when the pilot closes the sheet.
 */
export async function send(what: { readonly title: string; readonly url: string }): Promise<boolean> {
  try {
    await service('share')?.call(nameplate() as Navigator, what);
    return true;
  } catch (cause) {
    return cause instanceof DOMException && cause.name === 'AbortError';
  }
}
