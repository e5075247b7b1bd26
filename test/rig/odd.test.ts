import { expect, onTestFinished, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { encodeFrame } from '../../src/protocol/index.js';
import { connected, Pilot } from './pilot.js';
import { Rig } from './rig.js';

test.for([900, 2000])('a timer that answers after %i ms is read and written, and not called noisy', async (latency) => {
  const rig = await Rig.start({ timer: { latency } });
  const pilot = new Pilot(await rig.open());
  pilot.page.setDefaultTimeout(180_000);
  await pilot.clickConnect();
  await pilot.isConnected();
  await pilot.type({ 'DT time': '2:30' });
  await pilot.write();
  expect(await pilot.result()).toContain(en.write.verified.title);
  expect(rig.timer.core.content.times[10]).toBe(15_000);
  expect(await pilot.page.getByText('noisy').count()).toBe(0);
});

test('a device that sends lines of text is not called a timer, and the timer is still found when it wakes', async () => {
  const rig = await Rig.start();
  rig.timer.core.sleep();
  const talking = setInterval(() => rig.say(new TextEncoder().encode('$GPGGA,092750,5321.68,N*76\r\n')), 300);
  onTestFinished(() => clearInterval(talking));
  const pilot = new Pilot(await rig.open());
  await pilot.clickConnect();
  await pilot.sees(en.link.heard.title);
  await pilot.button(en.header.choosePort).waitFor();
  clearInterval(talking);
  rig.timer.core.press();
  await pilot.isConnected();
});

test('the answers of another timer are noticed, and the values shown are those of this one', async () => {
  const { rig, pilot } = await connected();
  rig.timer.core.onAnswer = ({ name }) => {
    if (name !== 'GETMEMORY') return;
    rig.timer.core.onAnswer = undefined;
    rig.say(encodeFrame(0x62, Array<number>(22).fill(9)));
  };
  await pilot.button(en.program.read).click();
  await pilot.sees(en.notes.strays.title);
  expect(await pilot.shown(['DT time'])).toEqual({ 'DT time': '3:00' });
});
