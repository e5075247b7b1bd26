import { type ProgramField, valueAt } from '../../program/index.js';
import { stepValue } from '../editing/edits.js';
import { fieldLabel, messages, slotInSentence } from '../messages/index.js';
import type { Session } from '../work/session.js';
import type { Bench } from './bench.js';
import type { Follow } from './follow.js';
import './bench-trim.css';

interface BenchTrimProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
}

/**
 * The positions of the function where the servos stand, with step keys.
 * While the servos follow, each step moves its servo.
 */
export function BenchTrim({ session, bench, follow }: BenchTrimProps) {
  const { bench: words, servoName } = messages.value;
  const working = session.editor.working.value;
  const at = bench.stand.at.value;
  if (!working || at === null) return null;
  return (
    <section class="stack panel bench-trim" aria-labelledby="trim-title">
      <h2 id="trim-title">{words.trim(slotInSentence(working.identity, at))}</h2>
      <div class="trim-servos">
        {Array.from({ length: working.identity.servos }, (_, servo) => (
          <Trim key={servo} session={session} field={{ kind: 'position', servo, slot: at }} name={servoName(servo)} />
        ))}
      </div>
      {!follow.on.value && <p class="hint">{words.waits}</p>}
    </section>
  );
}

interface TrimProps {
  readonly session: Session;
  readonly field: ProgramField;
  readonly name: string;
}

/** One value with a key for a step down and one for a step up. */
export function Trim({ session, field, name }: TrimProps) {
  const { less, moreOf } = messages.value;
  const { editor } = session;
  const working = editor.working.value;
  if (!working) return null;
  const label = fieldLabel(working.identity, field);
  const step = (by: number) => () => editor.apply(stepValue(working, field, by));
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset cannot be laid out as a grid everywhere
    <div class="trim" role="group" aria-label={label}>
      <span>
        {name} <output>{valueAt(working, field)}</output>
      </span>
      <button type="button" aria-label={less(label)} onClick={step(-1)}>
        {'−'}
      </button>
      <button type="button" aria-label={moreOf(label)} onClick={step(1)}>
        {'+'}
      </button>
    </div>
  );
}
