import { useSignal } from '@preact/signals';
import type { OneTab } from '../browser/one-tab.js';
import { clockText, messages } from '../messages/index.js';
import './framed-page.css';

/** Replaces the program while another tab of this page is at work. */
export function OtherTabPage({ tab }: { readonly tab: OneTab }) {
  const { otherTab } = messages.value;
  const isAsked = useSignal(false);
  const other = tab.other.value;
  return (
    <main class="framed">
      <h1>{other ? otherTab.holdsSince({ since: clockText(other.since) }) : otherTab.holds}</h1>
      <p role="status">{tab.silent.value ? otherTab.gone : isAsked.value && other?.busy && otherTab.busy}</p>
      <button
        type="button"
        class="primary"
        onClick={() => {
          isAsked.value = true;
          tab.ask();
        }}
      >
        {otherTab.takeOver}
      </button>
    </main>
  );
}
