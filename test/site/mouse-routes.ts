import type { Locator } from 'playwright';
import { en } from '../tools/en.js';

/** A drag over the table, from one field to another, and the selection after it. */
type Route = readonly [from: string, to: string, selected: string];

/** All of them are visible at once on a small screen. */
export const ROUTES: readonly Route[] = [
  ['Function 4, S2', 'Function 2, S1', '3 functions, 2 columns'],
  ['Function 2, S1', 'Function 4, S2', '3 functions, 2 columns'],
  ['Function 2, S3', 'Function 6, S3', '5 functions, 1 column'],
  ['Function 6, S1', 'Function 6, S3', '1 function, 3 columns'],
  ['Function 5, S3', 'Function 5, S1', '1 function, 3 columns'],
  ['Function 1 time', 'Function 3 time', '3 functions, 1 column'],
  ['Function 7 time', 'Function 5, S1', '3 functions, 3 columns'],
  ['Function 3 interval', 'Function 7 interval', '5 functions, 1 column'],
  ['Function 6, S2', 'Function 3 interval', '4 functions, 3 columns'],
  ['Function 7, S3', 'Function 2, S3', '6 functions, 1 column'],
  ['Function 1 interval', 'Function 1, S2', '1 function, 3 columns'],
  ['Function 3, S1', 'Function 5, S1', '3 functions, 1 column'],
];

/** Those that begin or end at the first or the last row. */
export const EDGE_ROUTES: readonly Route[] = [
  [en.program.motorStopTime, 'Function 2 time', '3 rows, 1 column'],
  ['DT time', 'Function 9, S2', '2 rows, 4 columns'],
  ['Start, S1', 'DT, S3', '11 rows, 3 columns'],
];

/** The place of the text of a field in the window: the browser drags the text there when it is selected. */
export function textOf(field: Locator): Promise<{ readonly x: number; readonly y: number }> {
  return field.evaluate((input) => {
    const { right, top, height } = input.getBoundingClientRect();
    return { x: right - 14, y: top + height / 2 };
  });
}
