import type { WriteReport } from '../../client/index.js';

/**
 * The memory, counted from 0, that became current during a write, and so may have taken some of its values: a request
 * does not say for which memory it is. Null for none.
 */
export function strayed(reports: readonly WriteReport[]): number | null {
  const stopped = reports.map((report) => report.stopped).find((error) => error?.code === 'other-memory');
  return stopped?.details.found ?? null;
}
