import type { Session } from '../session/session.js';
import { PrintButton } from './print-button.js';
import { readMemories } from './read-memories.js';

interface PrintMemoriesProps {
  readonly session: Session;
  readonly onPrint: (keys: readonly string[]) => void;
}

/** Opens the print view with all memories of the timer that were read. */
export function PrintMemories({ session, onPrint }: PrintMemoriesProps) {
  return <PrintButton keys={readMemories(session).map(({ key }) => key)} onPrint={onPrint} />;
}
