import type { WriteReport } from '../../client/index.js';

/**
 * The memory, counted from 0, that became current during a write, and so may have taken some of its values: a request
 * does not say for which memory it is. Null for none, and where nothing was to be changed: nothing was sent then.
 */
export function strayed(reports: readonly WriteReport[]): number | null {
  const report = reports.find(({ stopped }) => stopped?.code === 'other-memory');
  return report?.values.some(({ asked }) => asked) ? (report.stopped?.details.found ?? null) : null;
}
