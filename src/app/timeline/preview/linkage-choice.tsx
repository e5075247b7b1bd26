import { messages } from '../../messages/index.js';
import { type Linkages, SURFACES, type Surface } from './surfaces.js';
import './linkage-choice.css';

interface LinkageChoiceProps {
  readonly servos: number;
  readonly linkages: Linkages;
  readonly onChange: (linkages: Linkages) => void;
}

const NOTHING = '';

/** Which servo moves which surface of the sketch, and in which sense. */
export function LinkageChoice({ servos, linkages, onChange }: LinkageChoiceProps) {
  const { preview } = messages.value;
  return (
    <details class="linkages">
      <summary>{preview.assign}</summary>
      <div class="linkage-list">
        {SURFACES.map((surface) => (
          <LinkageRow key={surface} {...{ surface, servos, linkages, onChange }} />
        ))}
      </div>
    </details>
  );
}

function LinkageRow({ surface, servos, linkages, onChange }: LinkageChoiceProps & { readonly surface: Surface }) {
  const { preview, servoName } = messages.value;
  const { servo, reversed } = linkages[surface];
  const name = preview.surfaces[surface];
  return (
    <div class="linkage">
      <span aria-hidden="true">{name}</span>
      <select
        aria-label={preview.movedBy(name)}
        value={servo === null ? NOTHING : String(servo)}
        onChange={({ currentTarget: { value } }) =>
          onChange({ ...linkages, [surface]: { servo: value === NOTHING ? null : Number(value), reversed } })
        }
      >
        <option value={NOTHING}>{preview.nothing}</option>
        {Array.from({ length: servos }, (_, index) => (
          <option key={servoName(index)} value={String(index)}>
            {servoName(index)}
          </option>
        ))}
      </select>
      <label>
        <input
          type="checkbox"
          aria-label={preview.isReversed(name)}
          checked={reversed}
          disabled={servo === null}
          onChange={(event) => onChange({ ...linkages, [surface]: { servo, reversed: event.currentTarget.checked } })}
        />
        {preview.reversed}
      </label>
    </div>
  );
}
