import { useSignal } from '@preact/signals';
import type { OtherTab, TakeOver } from '../browser/other-tabs.js';
import { messages } from '../messages/index.js';

interface OtherTabNoticeProps {
  readonly tab: OtherTab;
  /** Asks the other tab for its port. The caller goes on once the tab has released it. */
  readonly onTakeOver: () => Promise<TakeOver>;
  readonly onDismiss: () => void;
}

/**
 * Another tab of this page holds the port: says which, and offers to take the port over. In place of the notice that
 * most often another program has it.
 */
export function OtherTabNotice({ tab, onTakeOver, onDismiss }: OtherTabNoticeProps) {
  const { otherTab, dismiss } = messages.value;
  const answer = useSignal<TakeOver | 'asking' | null>(tab.writing ? 'writing' : null);
  const take = async (): Promise<void> => {
    answer.value = 'asking';
    answer.value = await onTakeOver();
  };
  return (
    <div class="notice bad">
      <p>
        <strong>{otherTab.holds(tab.what, clockTime(tab.since))}</strong>{' '}
        {answer.value && answer.value !== 'released' && otherTab[answer.value]}
      </p>
      <button type="button" disabled={answer.value === 'asking'} onClick={() => void take()}>
        {otherTab.takeOver}
      </button>
      <button type="button" class="quiet" onClick={onDismiss}>
        {dismiss}
      </button>
    </div>
  );
}

function clockTime(time: number): string {
  const date = new Date(time);
  return [date.getHours(), date.getMinutes()].map((part) => String(part).padStart(2, '0')).join(':');
}
