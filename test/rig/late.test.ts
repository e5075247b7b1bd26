import { test } from 'vitest';
import { Pilot } from './pilot.js';
import { Rig } from './rig.js';

// Not in Firefox, whose chooser lists only what was there when it opened.
test('a port that is plugged in while the chooser is open can be chosen', async () => {
  const rig = await Rig.start({ chooser: true });
  const pilot = new Pilot(await rig.open());
  await rig.unplug();
  await pilot.clickConnect();
  await rig.chooser.shows(0);
  await rig.plug();
  await rig.chooser.shows(1);
  await rig.chooser.choose();
  await pilot.isReady();
});
