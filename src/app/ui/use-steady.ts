import { useMemo } from 'preact/hooks';
import { steady } from '../editing/steady.js';

/**
 * A narrow look at a model: the component is drawn anew when what it finds there says something else, and not at every
 * change of the program.
 * @param find of plain data.
 * @param inputs everything that it depends on but signals.
 */
export function useSteady<T>(find: () => T, inputs: readonly unknown[]): T {
  return useMemo(() => steady(find), inputs).value;
}
