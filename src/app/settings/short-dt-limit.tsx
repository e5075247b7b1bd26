import { useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { parseTime } from '../editing/units.js';
import { dtText, messages } from '../messages/index.js';
import type { Preferences } from '../session/preferences.js';
import './short-dt-limit.css';

/** Sets below which time a DT counts as short. */
export function ShortDtLimit({ preferences }: { readonly preferences: Preferences }) {
  const { shortDt, edits, unreadable } = messages.value;
  const text = useSignal(dtText(preferences.shortDt.value));
  const problem = useSignal<string | null>(null);
  const [hint, note] = [useId(), useId()];
  const take = (typed: string): void => {
    const read = parseTime(typed);
    if ('unreadable' in read) problem.value = unreadable[read.unreadable];
    else problem.value = preferences.setShortDt(read.value) ? null : edits.presets.refused;
    text.value = problem.value === null ? dtText(preferences.shortDt.value) : typed;
  };
  return (
    <>
      <label class="row short-dt-limit">
        {shortDt.settings.limit}
        <input
          type="text"
          inputMode="decimal"
          autocomplete="off"
          aria-describedby={`${note} ${hint}`}
          aria-invalid={problem.value !== null}
          value={text.value}
          onChange={({ currentTarget }) => take(currentTarget.value)}
        />
      </label>
      {problem.value && (
        <p class="bad-text" id={note} role="alert">
          {problem.value}
        </p>
      )}
      <p class="hint" id={hint}>
        {shortDt.settings.hint}
      </p>
    </>
  );
}
