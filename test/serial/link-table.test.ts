import { describe, expect, it } from 'vitest';
import { DEFAULT_SETTINGS, LINK_TABLE, type LinkEvent, type LinkStatus } from '../../src/serial/index.js';
import { nextStatus } from '../../src/serial/link-table.js';
import { answerNonsense, canBeOpened } from './bench.js';
import { type LinkBench, type LinkBenchOptions, linkBench, slowChooser, way } from './link-bench.js';

interface Journey {
  readonly name: string;
  readonly options?: LinkBenchOptions;
  readonly go: (bench: LinkBench) => Promise<unknown>;
  /** What the link told, and where it stands at the end of it. */
  readonly way: string;
}

const asleep = ({ timer }: LinkBench): void => timer.core.sleep();

/** Lets another program take the port as soon as the page lets go of it. */
function snatch({ port }: LinkBench): void {
  port.device.onopenchange = (opened) => {
    if (!opened) port.device.busy = true;
  };
}

/** Gives the port back. */
function release({ port }: LinkBench): void {
  port.device.onopenchange = null;
  port.device.busy = false;
}

const JOURNEYS: readonly Journey[] = [
  {
    name: 'a timer that answers',
    go: ({ connect }) => connect(),
    way: 'opening > searching > on',
  },
  {
    name: 'a port from the chooser',
    options: { plug: { granted: false } },
    go: ({ clock, link }) => clock.run(link.choose()),
    way: 'choosing > opening > searching > on',
  },
  {
    name: 'a chooser that is dismissed',
    go: ({ serial, link }) => {
      serial.choose(null);
      return link.choose();
    },
    way: 'choosing > off (nothing-chosen)',
  },
  {
    name: 'a browser without Web Serial',
    options: { link: { serial: undefined } },
    go: ({ link }) => link.choose(),
    way: 'off (unsupported)',
  },
  {
    name: 'a timer that sleeps',
    go: async (bench) => {
      asleep(bench);
      await bench.connect();
      await bench.clock.advance(5000);
      bench.timer.core.press();
      await bench.clock.advance(2000);
    },
    way: 'opening > searching > waiting > on',
  },
  {
    name: 'a port that another program holds for a while',
    options: { plug: { busy: true } },
    go: async ({ clock, link, port }) => {
      void link.connect(port);
      await clock.advance(5000);
      port.device.busy = false;
      await clock.advance(2000);
    },
    way: 'opening > searching > on',
  },
  {
    name: 'a port that another program holds',
    options: { plug: { busy: true } },
    go: ({ connect }) => connect(),
    way: 'opening > off (busy)',
  },
  {
    name: 'a port that is not plugged in',
    go: async ({ adapter, connect }) => {
      adapter.unplug();
      await connect();
    },
    way: 'opening > off (unplugged)',
  },
  {
    name: 'a port that is unplugged while another program holds it',
    options: { plug: { busy: true } },
    go: async ({ adapter, clock, link, port }) => {
      void link.connect(port);
      await clock.advance(2500);
      adapter.unplug();
      await clock.advance(0);
    },
    way: 'opening > off (unplugged)',
  },
  {
    name: 'settings that the port does not take',
    go: ({ port, connect }) => connect(port, { ...DEFAULT_SETTINGS, baudRate: 0 }),
    way: 'opening > off (bad-settings)',
  },
  {
    name: 'something that answers and is no timer',
    go: async (bench) => {
      const other = bench.serial.plug({}, { granted: true });
      void answerNonsense(other);
      await bench.connect(other);
    },
    way: 'opening > searching > off (bad-reply)',
  },
  {
    name: 'something that wakes and is no timer',
    go: async ({ serial, connect, clock }) => {
      const other = serial.plug({}, { granted: true });
      await connect(other);
      void answerNonsense(other);
      await clock.advance(5000);
    },
    way: 'opening > searching > waiting > off (bad-reply)',
  },
  {
    name: 'a port that is snatched between two rates',
    options: { answersAt: 19200 },
    go: async (bench) => {
      snatch(bench);
      void bench.link.connect(bench.port);
      await bench.clock.advance(5000);
      expect(bench.link.state).toMatchObject({ status: 'opening' });
      release(bench);
      await bench.clock.advance(5000);
    },
    way: 'opening > searching > opening > searching > on',
  },
  {
    name: 'a port that is snatched while it is waited for',
    go: async (bench) => {
      asleep(bench);
      await bench.connect();
      snatch(bench);
      await bench.clock.advance(10_000);
      expect(bench.link.state).toMatchObject({ status: 'opening' });
      release(bench);
      bench.timer.core.press();
      await bench.clock.advance(5000);
    },
    way: 'opening > searching > waiting > opening > searching > on',
  },
  {
    name: 'a cable that is pulled and plugged in again',
    go: async ({ connect, adapter, clock }) => {
      await connect();
      adapter.unplug();
      await clock.advance(60_000);
      adapter.replug();
      await clock.advance(1000);
    },
    way: 'opening > searching > on > away > opening > searching > on',
  },
  {
    name: 'a cable that returns as another port',
    go: async ({ connect, adapter, clock }) => {
      await connect();
      adapter.unplug();
      await clock.advance(60_000);
      adapter.returnAsNew();
      await clock.advance(1000);
    },
    way: 'opening > searching > on > away > opening > searching > on',
  },
  {
    name: 'a cable that is pulled while rates are tried',
    options: { plug: { timing: true } },
    go: async (bench) => {
      asleep(bench);
      void bench.link.connect(bench.port);
      await bench.clock.advance(2000);
      bench.adapter.unplug();
      await bench.clock.advance(1000);
    },
    way: 'opening > searching > away',
  },
  {
    name: 'a cable that is pulled while the timer is waited for',
    go: async (bench) => {
      asleep(bench);
      await bench.connect();
      await bench.clock.advance(2500);
      bench.adapter.unplug();
      await bench.clock.advance(1000);
    },
    way: 'opening > searching > waiting > away',
  },
  {
    name: 'a cable that is pulled again while the port is opened again',
    go: async ({ connect, adapter, port, clock }) => {
      await connect();
      adapter.unplug();
      await clock.advance(1000);
      port.device.busy = true;
      adapter.replug();
      await clock.advance(2500);
      adapter.unplug();
      await clock.advance(1000);
    },
    way: 'opening > searching > on > away > opening > away',
  },
  {
    name: 'a stream that fails with its plug in',
    go: async ({ connect, port, clock }) => {
      await connect();
      port.device.error('lost');
      await clock.advance(1000);
    },
    way: 'opening > searching > on > away > opening > searching > on',
  },
  {
    name: 'a stream that fails before its plug is seen to be out',
    go: async ({ connect, adapter, port, clock }) => {
      await connect();
      port.device.error('lost');
      await clock.advance(50);
      adapter.unplug();
      await clock.advance(1000);
    },
    way: 'opening > searching > on > away',
  },
  {
    name: 'a port that fails whenever it is open',
    go: async ({ port, clock, link }) => {
      port.device.onopenchange = (opened) => opened && port.device.error('lost');
      void link.connect(port);
      await clock.advance(60_000);
    },
    way: `${'opening > searching > away > '.repeat(6)}off (lost)`,
  },
  {
    name: 'a timer that falls silent and answers again',
    go: async (bench) => {
      await bench.connect();
      asleep(bench);
      bench.link.wait();
      await bench.clock.advance(3000);
      bench.timer.core.press();
      await bench.clock.advance(2000);
    },
    way: 'opening > searching > on > waiting > on',
  },
  {
    name: 'another timer in the place of the first',
    go: async ({ connect, timer, clock, link }) => {
      await connect();
      Object.assign(timer.core.identity, { firmware: '537' });
      await clock.run(link.recheck());
      await clock.advance(0);
    },
    way: 'opening > searching > on > searching > on',
  },
  {
    name: 'a pilot who stops the chooser',
    options: { link: { serial: slowChooser() } },
    go: ({ link }) => {
      void link.choose();
      return link.stop();
    },
    way: 'choosing > off',
  },
  {
    name: 'a pilot who stops the opening',
    options: { plug: { busy: true } },
    go: async ({ clock, link, port }) => {
      void link.connect(port);
      await clock.advance(2500);
      await clock.run(link.stop());
    },
    way: 'opening > closing > off',
  },
  {
    name: 'a pilot who stops the search',
    go: async (bench) => {
      asleep(bench);
      void bench.link.connect(bench.port);
      await bench.clock.advance(2000);
      await bench.clock.run(bench.link.stop());
    },
    way: 'opening > searching > closing > off',
  },
  {
    name: 'a pilot who stops the waiting',
    go: async (bench) => {
      asleep(bench);
      await bench.connect();
      await bench.clock.advance(2000);
      await bench.clock.run(bench.link.stop());
    },
    way: 'opening > searching > waiting > closing > off',
  },
  {
    name: 'a pilot who is done',
    go: async ({ connect, clock, link }) => {
      await connect();
      await clock.run(link.stop());
    },
    way: 'opening > searching > on > closing > off',
  },
  {
    name: 'a pilot who gives up a port that is away',
    go: async ({ connect, adapter, clock, link }) => {
      await connect();
      adapter.unplug();
      await clock.advance(1000);
      await clock.run(link.stop());
    },
    way: 'opening > searching > on > away > closing > off',
  },
  {
    name: 'a pilot who connects again without stopping',
    go: async ({ connect }) => {
      await connect();
      await connect();
    },
    way: 'opening > searching > on > closing > opening > searching > on',
  },
];

describe('the table', () => {
  const statuses = Object.keys(LINK_TABLE) as LinkStatus[];
  const events = [...new Set(statuses.flatMap((status) => Object.keys(LINK_TABLE[status])))] as LinkEvent[];

  it('leads nowhere else', () => {
    for (const rows of Object.values(LINK_TABLE)) {
      for (const next of Object.values(rows)) expect(statuses).toContain(next);
    }
  });

  it('refuses every event that it does not list', () => {
    for (const status of statuses) {
      for (const event of events) {
        if (event in LINK_TABLE[status]) continue;
        expect(() => nextStatus(status, event), `${status} must refuse ${event}`).toThrow(event);
      }
    }
  });
});

describe('the way of', () => {
  /** Each step that was taken: from where to where. */
  const steps = new Set<string>();

  it.each(JOURNEYS)('$name', async ({ options, go, way: expected }) => {
    const bench = linkBench(options);
    const { states, clock, link, adapter } = bench;
    await go(bench);
    expect(way(states)).toBe(expected);
    expect(link.state).toBe(states.at(-1));

    // Wherever it ended, it can be stopped, and leaves the port as it found it.
    await clock.run(link.stop());
    expect(link.state.status).toBe('off');
    release(bench);
    adapter.replug();
    expect(await canBeOpened(adapter.port)).toBe(true);

    const statuses = ['off', ...states.map(({ status }) => status)];
    for (const [i, status] of statuses.slice(1).entries()) steps.add(`${statuses[i]} > ${status}`);
  });

  it('all of them together takes every row of the table', () => {
    for (const [status, rows] of Object.entries(LINK_TABLE)) {
      for (const next of Object.values(rows)) expect(steps).toContain(`${status} > ${next}`);
    }
  });
});
