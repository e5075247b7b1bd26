import { checkProgram, type FindingCode, type TimerProgram } from '../program/index.js';
import { TimerError } from './errors.js';

/** What a write may do although the check calls it serious. */
export interface DespiteOptions {
  /**
   * The serious findings of `checkProgram` that the pilot has seen and wants all the same, by their codes. Any other
   * refuses the write with TimerError `serious`. Default: none.
   */
  readonly despite?: readonly FindingCode[] | undefined;
}

/** @throws TimerError `serious` for what may cost a model and nobody has agreed to; CodecError `wrong-count`. */
export function requireAgreed(goal: TimerProgram, { despite = [] }: DespiteOptions, baseline?: TimerProgram): void {
  const findings = checkProgram(goal, { baseline }).filter(
    ({ severity, code }) => severity === 'serious' && !despite.includes(code),
  );
  if (findings.length === 0) return;
  const codes = [...new Set(findings.map(({ code }) => code))];
  throw new TimerError('serious', `${codes.join(', ')}: look at it, then write despite it`, { findings });
}
