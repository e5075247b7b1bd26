import { useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { readTime } from '../editing/units.js';
import { dtText, messages, presetText } from '../messages/index.js';
import type { Preferences } from '../records/preferences.js';
import { Problem } from '../ui/problem.js';

/** The times of the presets for DT, and below which time a DT counts as short. */
export function DtTimes({ preferences }: { readonly preferences: Preferences }) {
  const { shortDt, edits } = messages.value;
  const hint = useId();
  return (
    <>
      <TimesField
        label={edits.presets.title}
        text={preferences.presets.value.map(presetText).join(', ')}
        onTake={(times) => preferences.setPresets(times)}
      />
      <TimesField
        label={shortDt.settings.limit}
        text={dtText(preferences.shortDt.value)}
        describedBy={hint}
        onTake={([time, ...more]) => time !== undefined && more.length === 0 && preferences.setShortDt(time)}
      />
      <p class="hint" id={hint}>
        {shortDt.settings.hint}
      </p>
    </>
  );
}

interface TimesFieldProps {
  readonly label: string;
  /** The present times. */
  readonly text: string;
  readonly describedBy?: string;
  /** @returns false when they are refused. */
  readonly onTake: (times: readonly number[]) => boolean;
}

/** One or more times, with commas between them. */
function TimesField({ label, text, describedBy, onTake }: TimesFieldProps) {
  const typed = useSignal<string | null>(null);
  const take = (said: string): void => {
    // A comma between digits is a decimal comma.
    const texts = said.split(/[;\n]|,(?!\d)/).filter((each) => each.trim() !== '');
    const times = texts.flatMap((each): number[] => {
      const read = readTime(each, { isDt: true });
      return 'value' in read ? [read.value] : [];
    });
    typed.value = times.length === texts.length && onTake(times) ? null : said;
  };
  return (
    <>
      <label class="stack">
        {label}
        <textarea
          rows={1}
          autocomplete="off"
          aria-describedby={describedBy}
          aria-invalid={typed.value !== null}
          value={typed.value ?? text}
          onChange={({ currentTarget }) => take(currentTarget.value)}
        />
      </label>
      <Problem text={typed.value === null ? null : messages.value.edits.presets.refused} />
    </>
  );
}
