import { COMMANDS, commandOf } from '../../protocol/index.js';
import type { LineRecord } from '../timer/line-record.js';
import type { Seen } from './conclusions.js';

/** A pair that takes longer was not one exchange: the page or its computer stood still. */
const LONGEST = 60_000;

/** What a part of the line shows without any question of its own. @param records the oldest first. */
export function observed(records: readonly LineRecord[]): Pick<Seen, 'indices' | 'delays'> {
  // An adapter may return what it is sent.
  const isEcho = ({ direction, frame }: LineRecord): boolean =>
    direction === 'in' && frame !== null && commandOf(frame.code)?.direction === 'request';
  const heard = records.filter((record) => !isEcho(record));
  const indices = heard.flatMap(({ direction, frame }) =>
    direction === 'in' && frame?.code === COMMANDS.GETMEMORY.reply ? [frame.data[0] ?? null] : [],
  );
  const delays = heard.flatMap((record, at) => {
    const next = heard[at + 1];
    const isExchange = record.direction === 'out' && next?.direction === 'in' && next.frame !== null;
    const delay = isExchange ? next.time - record.time : -1;
    return delay >= 0 && delay <= LONGEST ? [delay] : [];
  });
  return { indices, delays };
}
