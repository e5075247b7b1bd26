import { differences, LIMITS, type SettingVersion, type TimerProgram } from '../../program/index.js';
import { isOfOneShape } from '../editing/shape.js';
import { isSame, type SettingRecord } from '../storage/index.js';

type Versions = SettingVersion[] | undefined;

/** The versions of a setting that now holds a program: if that changes a value, what it held before is the latest. */
export function versionsAfter(before: SettingRecord | undefined, program: TimerProgram, until: number): Versions {
  if (!before || hasSameValues(before.setting.program, program)) return before?.versions;
  const { at, from, program: held } = before.setting;
  return [{ until, at, from, program: held }, ...(before.versions ?? [])].slice(0, LIMITS.versions);
}

/** The versions of a setting that an import replaces: those of both, and what it held, if the file does not have it. */
export function versionsWith(
  brought: readonly SettingVersion[] = [],
  before: SettingRecord | undefined,
  program: TimerProgram,
): Versions {
  const isBrought = brought.some((each) => before && hasSameValues(each.program, before.setting.program));
  const here = isBrought ? before?.versions : versionsAfter(before, program, Date.now());
  const all = [...brought, ...(here ?? []).filter((each) => !brought.some((other) => isSame(each, other)))];
  return all.length === 0 ? undefined : all.sort((a, b) => b.until - a.until).slice(0, LIMITS.versions);
}

/** Whether no value differs. Which memory they come from does not count. */
export function hasSameValues(a: TimerProgram, b: TimerProgram): boolean {
  return isOfOneShape(a.identity, b.identity) && differences(a, b).length === 0;
}
