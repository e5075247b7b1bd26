import { apart } from './apart.js';

/** A fact up to so many characters does not break: it fits on a line of any screen. */
const SHORT = 20;

/** “Lancer 07 · calm · 18 Nov”: joins the facts that are there. No line begins with the dot, or within a short fact. */
export const dotted = (facts: readonly (string | null | undefined | false)[]): string =>
  facts.flatMap((fact) => (fact ? [apart(whole(fact))] : [])).join('\u00a0· ');

/** A short fact, so that it stays on one line. */
export const whole = (fact: string): string =>
  fact.length > SHORT ? fact : fact.replaceAll(' ', '\u00a0').replaceAll('-', '-\u2060');
