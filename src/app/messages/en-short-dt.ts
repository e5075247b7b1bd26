import { whole } from './dotted.js';

/** A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round. */
export const shortDt = {
  /** @param memory null where the timer does not say which one is current. */
  held: (memory: string | null, dt: string) =>
    memory === null ? `DT is ${whole(dt)}.` : `DT of ${memory} is ${whole(dt)}.`,
  /** @param remembered whether this memory held that DT before. */
  ask: (back: string, remembered: boolean) => `${remembered ? 'Put it back' : 'Set it'} to ${whole(back)}?`,
  putBack: (back: string, remembered: boolean) => `${remembered ? 'Put DT back' : 'Set DT'} to ${whole(back)}…`,
  /** @param memory null for the one that was current when the pilot connected. */
  disconnect: (memory: string | null, dt: string) =>
    `Disconnect with ${memory === null ? '' : `${memory}, `}${whole(`DT ${dt}`)}`,
  /** Something that was typed prevents every write. */
  blocked: 'Something that you typed cannot be written yet. Correct it before you put DT back.',
  settings: {
    limit: 'A DT is short below',
    hint: 'A shorter DT is red, and the page asks before you disconnect. With 0 s it never asks.',
  },
};
