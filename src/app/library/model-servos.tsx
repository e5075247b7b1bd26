import { useSignal } from '@preact/signals';
import type { ServoUse, TimerProgram } from '../../program/index.js';
import { moreMessages } from '../messages/more.js';
import { dutyName, servoName } from '../messages/names.js';
import type { ModelRecord } from '../storage/index.js';
import { ServoDialog } from '../timeline/preview/servo-dialog.js';
import { guessedUses } from '../timeline/preview/surfaces.js';
import type { Session } from '../work/session.js';

interface ModelServosProps {
  readonly session: Session;
  readonly record: ModelRecord;
  readonly onChange: (servos: readonly ServoUse[]) => void;
}

/** What the servos of the model move, and between which steps. */
export function ModelServos({ session, record, onChange }: ModelServosProps) {
  const { model: words } = moreMessages.value.library;
  const { preview } = moreMessages.value;
  const naming = useSignal(false);
  const { servos } = record.model;
  const program = programOf(session, record);
  const isSaid = servos.length > 0;
  return (
    <section class="stack">
      <h3>{words.servos}</h3>
      {isSaid ? (
        <ul>
          {servos.map((use, servo) => (
            <li key={servoName(servo)}>
              <b>{servoName(servo)}</b> {dutyName(use)}
              {use.duty !== 'none' && <span class="hint"> {words.servoWay({ low: use.low, high: use.high })}</span>}
            </li>
          ))}
        </ul>
      ) : (
        !program && <p class="hint">{words.servosUnknown}</p>
      )}
      <div class="buttons">
        <button type="button" disabled={!isSaid && !program} onClick={() => (naming.value = true)}>
          {preview.nameServos}
        </button>
      </div>
      <ServoDialog
        open={naming.value}
        uses={isSaid ? servos : program ? guessedUses(program) : []}
        onSave={(uses) => {
          naming.value = false;
          onChange(uses ?? []);
        }}
        onCancel={() => (naming.value = false)}
      />
    </section>
  );
}

/** A program of the model, from which to guess. */
function programOf({ library }: Session, { key, verified }: ModelRecord): TimerProgram | null {
  const setting = library.settings.list.value.find((each) => each.setting.model === key);
  return setting?.setting.program ?? verified[0]?.program ?? null;
}
