import { useComputed } from '@preact/signals';
import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { messages, presetText } from '../messages/index.js';
import type { Preferences } from '../records/preferences.js';
import './presets.css';

interface DtPresetsProps {
  readonly editor: Editor;
  readonly preferences: Preferences;
  /** The slot of DT. */
  readonly slot: number;
}

/** Buttons for the DT of a contest or a trimming flight. The settings have the list. */
export function DtPresets({ editor, preferences, slot }: DtPresetsProps) {
  const { edits, program } = messages.value;
  const field: ProgramField = { kind: 'time', slot };
  const params = { field: fieldKey(field) };
  // What is typed is no value yet: then the value before it is no longer meant.
  const current = useComputed(() =>
    editor.unreadable.value.has(fieldKey(field)) ? null : editor.working.value?.times[slot],
  ).value;
  const presets = preferences.presets.value;
  if (presets.length === 0) return null;
  return (
    <fieldset class="row gap-1 presets">
      <legend class="visually-hidden">{edits.presets.title}</legend>
      <span class="hint" aria-hidden="true">
        {program.dt}
      </span>
      {presets.map((value) => (
        <button
          type="button"
          key={value}
          aria-label={edits.presets.use({ time: presetText(value) })}
          aria-current={value === current}
          onClick={() => editor.apply(setValues({ code: 'change', params }, [{ field, value }]))}
        >
          {presetText(value)}
        </button>
      ))}
    </fieldset>
  );
}
