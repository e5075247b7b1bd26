import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { connected } from './pilot.js';

const HOLDS = 'holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.';

const Q = { timer: { identity: { timerClass: 'Q' } } } as const;

test('unplugged after the last byte of a write: the memory stays uncertain until the timer is read', async () => {
  const { rig, pilot } = await connected(Q);
  const { page } = pilot;
  const band = page.getByRole('region', { name: en.knowledge.title });
  await pilot.type({ 'DT time': '6:00' });
  await pilot.review();
  // The timer has the whole of the write, and its answer does not arrive.
  rig.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && void rig.unplug();
  await pilot.startWriting();
  expect(await pilot.result()).toContain(en.write.unknown.title);
  rig.timer.core.onAnswer = undefined;
  expect(rig.timer.core.content.times[10]).toBe(36_000);
  await band.getByText(HOLDS).waitFor();

  await pilot.button(en.program.undoAll).click();
  await pilot.button(en.header.stop).click();
  await pilot.button(en.header.connect).first().waitFor();
  await band.getByText(HOLDS).waitFor();
  await page.reload();
  await band.getByText(HOLDS).waitFor();
  expect(await page.getByText(/^As in the timer|^was 3:00|They have not been written/).count()).toBe(0);

  await rig.plug();
  await pilot.button(en.knowledge.connect).click();
  await pilot.isConnected();
  expect(await band.count()).toBe(0);
  expect(await pilot.shown(['DT time'])).toEqual({ 'DT time': '6:00' });
});

test('another timer under the head between dialog and Write: nothing is written to it, and the head names it', async () => {
  const { rig, pilot } = await connected(Q);
  const { core } = rig.timer;
  await pilot.type({ 'DT time': '6:00' });
  await pilot.review();
  Object.assign(core.identity, { timerClass: 'B' });
  const before = structuredClone(core.memories);
  await pilot.startWriting();
  await pilot.page.getByRole('dialog').getByText(en.timer['other-timer'].title).waitFor();
  await pilot.page.getByRole('banner').getByText('F1B').waitFor();
  expect(core.memories).toEqual(before);
  expect(core.answered.some(({ name }) => name.startsWith('SET'))).toBe(false);
});

test('another content under the head between dialog and Write: it is shown, and asked again', async () => {
  const { rig, pilot } = await connected(Q);
  const { core } = rig.timer;
  await pilot.type({ 'DT time': '6:00' });
  await pilot.review();
  core.content.times[10] = 12_000;
  await pilot.startWriting();
  await pilot.page.getByRole('dialog').getByText(en.timer.stale.title).waitFor();
  expect(core.content.times[10]).toBe(12_000);
  expect(core.answered.some(({ name }) => name.startsWith('SET'))).toBe(false);
  await pilot.startWriting();
  expect(await pilot.result()).toContain(en.write.verified.title);
  expect(core.content.times[10]).toBe(36_000);
});
