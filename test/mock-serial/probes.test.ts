import { describe, expect, test } from 'vitest';
import { PROBES, TOUCHED } from './probes/index.js';
import { onMock } from './probes/on-mock.js';

/* What a page sees by the standard, and with Chromium's ways. test/rig/probes.test.ts runs the list in Chromium. */

describe.each(Object.entries(PROBES))('%s', (subject, probes) => {
  const isTouched = TOUCHED.includes(subject);
  test.each(probes.map((each) => [each.name, each] as const))('%s', async (_, probe) => {
    const { says, inChromium, way, why } = probe;
    expect(await onMock(probe, isTouched, false)).toBe(says);
    if (way) expect(await onMock(probe, isTouched, { [way]: true })).toBe(inChromium);
    expect(await onMock(probe, isTouched, true)).toBe(why ? says : inChromium);
  });
});
