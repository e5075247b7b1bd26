import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { MockSerialPort } from '../../src/mock-serial/index.js';
import { RATES } from '../../src/serial/index.js';
import { canBeOpened } from './bench.js';
import { connectionOf, type LinkBench, linkBench, portOf } from './link-bench.js';

/** What pilot, cable, timer and computer may do at any time. */
const ACTIONS: Readonly<Record<string, (bench: LinkBench) => void>> = {
  unplug: ({ adapter }) => adapter.unplug(),
  replug: ({ adapter }) => void (adapter.port.connected || adapter.replug()),
  replugSame: ({ adapter }) => void (adapter.port.connected || adapter.replug({ samePort: true })),
  returnAsNew: ({ adapter }) => void (adapter.port.connected || adapter.returnAsNew()),
  hangUp: ({ adapter }) => adapter.port.device.error('lost'),
  disturb: ({ adapter }) => adapter.port.device.error('framing'),
  sleep: ({ timer }) => timer.core.sleep(),
  press: ({ timer }) => timer.core.press(),
  take: ({ adapter }) => void Object.assign(adapter.port.device, { busy: true }),
  release: ({ adapter }) => void Object.assign(adapter.port.device, { busy: false }),
  connect: ({ adapter, link }) => void link.connect(adapter.port),
  choose: ({ adapter, serial, link }) => {
    serial.choose(adapter.port);
    void link.choose();
  },
  dismiss: ({ serial, link }) => {
    serial.choose(null);
    void link.choose();
  },
  stop: ({ link }) => void link.stop(),
  wait: ({ link }) => link.wait(),
  recheck: ({ link }) => void link.recheck(),
};

/** The actions of which the browser tells by an event. */
const PLUG: ReadonlySet<unknown> = new Set(['unplug', 'replug', 'replugSame', 'returnAsNew']);

const action = fc.oneof(
  { weight: 3, arbitrary: fc.constantFrom(...Object.keys(ACTIONS)) },
  { weight: 1, arbitrary: fc.constant('read') },
  { weight: 1, arbitrary: fc.constantFrom(...RATES).map((rate) => ({ rate })) },
  { weight: 3, arbitrary: fc.oneof(fc.nat(700), fc.nat(20_000)).map((ms) => ({ ms })) },
);

it('whatever happens, at most one port is open, and the timer is found when nothing disturbs any more', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(action, { maxLength: 40 }), fc.boolean(), async (actions, timing) => {
      const bench = linkBench({ plug: { timing } });
      const { link, adapter, clock, timer } = bench;
      const ports = new Set<MockSerialPort>();
      const jobs: Promise<unknown>[] = [];
      // A device that was plugged in again is at the last of its ports.
      const opened = (): MockSerialPort[] => {
        const open = [...ports].filter(({ device }) => device.opened);
        return [...new Map(open.map((port) => [port.device, port])).values()];
      };
      const watch = (): void => {
        ports.add(adapter.port);
        adapter.port.device.onopenchange = () => expect(opened().length).toBeLessThanOrEqual(1);
      };
      watch();
      // Of a plug that is pulled and put back in one go the link hears a moment later.
      let isHeard = true;

      for (const what of actions) {
        isHeard = typeof what === 'object' && 'ms' in what ? true : isHeard && !PLUG.has(what);
        if (typeof what === 'string' && what !== 'read') ACTIONS[what]?.(bench);
        else if (what === 'read') {
          if (link.state.status === 'on')
            jobs.push(
              connectionOf(link)
                .client.readProgram()
                .catch(() => {}),
            );
        } else if ('rate' in what) adapter.answersAt = what.rate;
        else await clock.advance(what.ms);
        watch();
        if (link.state.status === 'off') expect(opened()).toEqual([]);
        if (link.state.status === 'on' && isHeard) expect(opened()[0]).toBe(link.state.port);
      }

      if (!adapter.port.connected) adapter.replug();
      adapter.port.device.busy = false;
      timer.core.press();
      // Nothing has asked the timer since it was changed for one of another rate.
      void link.recheck();
      await clock.advance(60_000);
      if (link.state.status === 'off') await clock.run(link.connect(adapter.port));
      await clock.advance(30_000);
      expect(link.state.status).toBe('on');
      expect(portOf(link)).toBe(adapter.port);
      expect(opened()).toHaveLength(1);
      await clock.run(connectionOf(link).client.readProgram());
      await clock.run(Promise.all(jobs));

      await clock.run(link.stop());
      expect(opened()).toEqual([]);
      expect(await canBeOpened(adapter.port)).toBe(true);
    }),
    { numRuns: 300, examples: [[['choose', { ms: 0 }, 'unplug', 'replug'], false]] },
  );
});
