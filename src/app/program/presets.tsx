import { useComputed, useSignal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { type Ambiguous, readTime } from '../editing/units.js';
import { dtText, messages, presetText } from '../messages/index.js';
import type { Preferences } from '../session/preferences.js';
import { Icon } from '../ui/icon.js';
import { TimeQuestion } from '../ui/time-question.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import './presets.css';

interface DtPresetsProps {
  readonly editor: Editor;
  readonly preferences: Preferences;
  /** The slot of DT. */
  readonly slot: number;
}

/** Buttons for the DT of a contest or a trimming flight, and the pilot's own. */
export function DtPresets({ editor, preferences, slot }: DtPresetsProps) {
  const { presets: words } = messages.value.edits;
  const changing = useSignal(false);
  const field: ProgramField = { kind: 'time', slot };
  const key = fieldKey(field);
  const current = useComputed(() => editor.working.value?.times[slot]).value;
  const box = useHandedFocus('[aria-expanded]');
  return (
    <div class={`presets ${changing.value ? 'changing' : ''}`} {...box}>
      <fieldset class="chips">
        <legend>
          <span aria-hidden="true">{messages.value.program.dt}</span>
          <span class="visually-hidden">{words.title}</span>
        </legend>
        {preferences.presets.value.map((value) => (
          <button
            type="button"
            key={value}
            aria-label={words.use(presetText(value))}
            aria-current={value === current}
            onClick={() => editor.apply(setValues({ code: 'change', params: { field: key } }, [{ field, value }]))}
          >
            {presetText(value)}
          </button>
        ))}
        <button
          type="button"
          class="quiet"
          aria-label={words.change}
          title={words.change}
          aria-expanded={changing.value}
          onClick={() => (changing.value = !changing.value)}
        >
          <Icon path="M3 17L4 13L13.5 3.5L16.5 6.5L7 16ZM11.5 5.5L14.5 8.5" />
        </button>
      </fieldset>
      {changing.value && (
        <PresetSettings editor={editor} preferences={preferences} onDone={() => (changing.value = false)} />
      )}
    </div>
  );
}

/** An ambiguous text, and what its answer is for. */
interface Asked {
  readonly label: string;
  readonly either: Ambiguous['either'];
  readonly use: (value: number) => boolean;
}

interface PresetSettingsProps extends Omit<DtPresetsProps, 'slot'> {
  readonly onDone: () => void;
}

function PresetSettings({ editor, preferences, onDone }: PresetSettingsProps) {
  const { presets: words } = messages.value.edits;
  const form = useRef<HTMLFormElement>(null);
  // Among the large figures of a phone it opens below what is in sight.
  useLayoutEffect(() => form.current?.scrollIntoView({ block: 'nearest' }), []);
  const added = useSignal('');
  const limitInput = useRef<HTMLInputElement>(null);
  const limit = useSignal(dtText(editor.shortDt.value));
  const problem = useSignal<string | null>(null);
  const asked = useSignal<Asked | null>(null);
  const takeValue = (value: number, use: (value: number) => boolean): void => {
    asked.value = null;
    problem.value = use(value) ? null : words.refused;
  };
  const take = (text: string, label: string, use: (value: number) => boolean): void => {
    const read = readTime(text, { isDt: true });
    asked.value = 'either' in read ? { label, either: read.either, use } : null;
    if ('value' in read) takeValue(read.value, use);
    else problem.value = 'either' in read ? null : messages.value.unreadable[read.unreadable];
  };
  const add = (value: number): boolean => {
    const isAdded = preferences.addPreset(value);
    if (isAdded) added.value = '';
    return isAdded;
  };
  const setLimit = (value: number): boolean => {
    const isSet = preferences.setShortDt(value);
    if (isSet) limit.value = dtText(value);
    return isSet;
  };
  return (
    <form
      ref={form}
      class="preset-settings"
      onSubmit={(event) => {
        event.preventDefault();
        // Enter belonged to the field of the limit; no preset is added.
        if (added.value === '' && document.activeElement === limitInput.current) return;
        take(added.value, words.add, add);
      }}
    >
      <ul>
        {preferences.presets.value.map((value) => (
          <li key={value}>
            {presetText(value)}
            <button
              type="button"
              class="preset-remove quiet"
              aria-label={words.remove(presetText(value))}
              onClick={() => preferences.removePreset(value)}
            >
              <Icon path="M6 6L14 14M14 6L6 14" />
            </button>
          </li>
        ))}
      </ul>
      <label>
        {words.add}
        <input
          type="text"
          placeholder={words.example}
          inputMode="decimal"
          autocomplete="off"
          value={added.value}
          onInput={(event) => {
            added.value = event.currentTarget.value;
            asked.value = null;
          }}
        />
      </label>
      <button type="submit">{words.addButton}</button>
      <label>
        {words.shortDt}
        <input
          ref={limitInput}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          value={limit.value}
          onChange={(event) => {
            limit.value = event.currentTarget.value;
            take(limit.value, words.shortDt, setLimit);
          }}
        />
      </label>
      <button type="button" class="quiet" onClick={onDone}>
        {words.done}
      </button>
      {asked.value && (
        <TimeQuestion
          label={asked.value.label}
          either={asked.value.either}
          onAnswer={(value) => asked.value && takeValue(value, asked.value.use)}
          onEscape={() => {
            asked.value = null;
          }}
        />
      )}
      {problem.value && (
        <p class="notes bad-text" role="alert">
          {problem.value}
        </p>
      )}
    </form>
  );
}
