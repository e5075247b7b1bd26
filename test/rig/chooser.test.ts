import { test } from 'vitest';
import { en } from '../tools/en.js';
import { Pilot } from './pilot.js';
import { Rig } from './rig.js';

test('choosing nothing is reported; a chosen port is connected, and needs no choice the next time', async () => {
  const rig = await Rig.start({ chooser: true });
  const pilot = new Pilot(await rig.open());

  await pilot.clickConnect();
  await rig.chooser.shows(1);
  await rig.chooser.dismiss();
  await pilot.sees(en.connection['nothing-chosen'].title);

  await pilot.clickConnect();
  await rig.chooser.shows(1);
  await rig.chooser.choose();
  await pilot.isReady();
  await pilot.sees('firmware 536');

  await pilot.button(en.header.disconnect).click();
  await pilot.clickConnect();
  await pilot.isReady();
});
