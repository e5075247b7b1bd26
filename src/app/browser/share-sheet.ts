import { nameplate, service } from './services.js';

/** Whether the system can hand a link to other programs and people. */
export function canSend(): boolean {
  return service('share') !== null;
}

/** Opens the system's sheet for sharing. Where it refuses, nothing happens: the link stands there to copy. */
export async function send(what: { readonly title: string; readonly url: string }): Promise<void> {
  await service('share')
    ?.call(nameplate() as Navigator, what)
    .catch(() => {});
}
