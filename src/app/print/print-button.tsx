import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import { memoryKey } from './print-order.js';

interface PrintButtonProps {
  /** The keys of what to print. */
  readonly keys: readonly string[];
  readonly onPrint: (keys: readonly string[]) => void;
}

/** Opens the print view with these programs. */
export function PrintButton({ keys, onPrint }: PrintButtonProps) {
  return (
    <button type="button" data-print disabled={keys.length === 0} onClick={() => onPrint(keys)}>
      {messages.value.views.print}
    </button>
  );
}

/** Opens the print view with all memories of the timer that were read. */
export function PrintMemories({ session, onPrint }: { readonly session: Session } & Pick<PrintButtonProps, 'onPrint'>) {
  const read = session.standings.readMemories();
  return <PrintButton keys={read.map(({ memory }) => memoryKey(memory))} onPrint={onPrint} />;
}
