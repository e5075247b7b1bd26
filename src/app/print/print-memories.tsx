import type { Session } from '../session/session.js';
import { PrintButton } from './print-button.js';
import { memoryKey } from './print-order.js';

interface PrintMemoriesProps {
  readonly session: Session;
  readonly onPrint: (keys: readonly string[]) => void;
}

/** Opens the print view with all memories of the timer that were read. */
export function PrintMemories({ session, onPrint }: PrintMemoriesProps) {
  const read = session.standings.readMemories();
  return <PrintButton keys={read.map(({ memory }) => memoryKey(memory))} onPrint={onPrint} />;
}
