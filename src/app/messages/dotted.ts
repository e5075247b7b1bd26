/** “Lancer 07 · calm · 18 Nov”: what is there of several facts. No line begins with the dot. */
export const dotted = (facts: readonly (string | null | undefined | false)[]): string =>
  facts.filter(Boolean).join('\u00a0· ');
