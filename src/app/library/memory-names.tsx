import { LIMITS } from '../../program/index.js';
import { libraryMessages } from '../messages/en-library.js';
import { messages } from '../messages/index.js';
import { plainName } from '../session/plain-names.js';
import type { Session } from '../session/session.js';
import type { ModelRecord } from '../storage/index.js';
import { TextField } from './text-field.js';
import './memory-names.css';

/** The number of memories of most timers. */
const USUAL_MEMORIES = 4;

interface MemoryNamesProps {
  readonly session: Session;
  readonly record: ModelRecord;
  readonly onChange: (names: readonly string[]) => void;
}

/** The pilot's names for the memories of the model's timer. */
export function MemoryNames({ session, record, onChange }: MemoryNamesProps) {
  const { model: words } = libraryMessages;
  const { memoryName } = messages.value;
  const names = record.model.memoryNames;
  const count = Math.max(memoriesOf(session, record), names.length);
  return (
    <fieldset class="memory-names">
      <legend>{words.memories}</legend>
      <div>
        {Array.from({ length: count }, (_, memory) => (
          <TextField
            key={memory}
            label={memoryName(memory)}
            value={names[memory] ?? ''}
            longest={LIMITS.name}
            asKept={plainName}
            onSave={(text) => {
              const now = session.library.models.get(record.key)?.model.memoryNames ?? names;
              const length = Math.max(now.length, memory + 1);
              onChange(Array.from({ length }, (_, at) => (at === memory ? text : (now[at] ?? ''))));
            }}
          />
        ))}
      </div>
      <p class="hint">{words.memoriesHint}</p>
    </fieldset>
  );
}

/** How many memories its timer has, as far as the library shows it. */
function memoriesOf({ library }: Session, { key, verified }: ModelRecord): number {
  const programs = [
    ...verified.map(({ program }) => program),
    ...library.settings.list.value.filter(({ setting }) => setting.model === key).map(({ setting }) => setting.program),
  ];
  return (
    Math.max(...programs.map(({ identity }) => identity.memories).filter((count) => count > 1), 0) || USUAL_MEMORIES
  );
}
