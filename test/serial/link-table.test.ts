import { describe, expect, it } from 'vitest';
import { DEFAULT_SETTINGS, LINK_TABLE, type LinkStatus } from '../../src/serial/index.js';
import { type LinkEvent, nextStatus } from '../../src/serial/link-table.js';
import { answerNonsense, canBeOpened } from './bench.js';
import { type LinkBench, type LinkBenchOptions, linkBench, slowChooser, way } from './link-bench.js';

/** Something that a pilot, a cable, a timer or another program does. */
type Act = (bench: LinkBench) => unknown;

/** Connects, and turns the clock until the link has settled. */
const connect: Act = (bench) => bench.connect();
/** Begins to connect. */
const begin: Act = ({ link, port }) => void link.connect(port);
const choose: Act = ({ clock, link }) => clock.run(link.choose());
const stop: Act = ({ clock, link }) => clock.run(link.stop());
const wait =
  (ms: number): Act =>
  ({ clock }) =>
    clock.advance(ms);
const unplug: Act = ({ adapter }) => adapter.unplug();
const replug: Act = ({ adapter }) => adapter.replug();
/** The stream of the port fails. */
const fail: Act = ({ port }) => port.device.error('lost');
const sleep: Act = ({ timer }) => timer.core.sleep();
const press: Act = ({ timer }) => timer.core.press();
/** Another program takes the port. */
const hold: Act = ({ port }) => void Object.assign(port.device, { busy: true });
/** It does so as soon as the page lets go of it. */
const snatch: Act = (bench) => {
  bench.port.device.onopenchange = (opened) => opened || hold(bench);
};
const release: Act = ({ port }) => void Object.assign(port.device, { busy: false, onopenchange: null });
const isOpening: Act = ({ link }) => expect(link.state).toMatchObject({ status: 'opening' });
/** Another port, with something that answers and is no timer. */
const meetNonsense =
  (answersFirst: boolean): Act =>
  async (bench) => {
    const other = bench.serial.plug({}, { granted: true });
    if (answersFirst) void answerNonsense(other);
    await bench.connect(other);
    if (!answersFirst) void answerNonsense(other);
  };

const BUSY: LinkBenchOptions = { plug: { busy: true } };
const NO_SUCH_RATE = { ...DEFAULT_SETTINGS, baudRate: 0 };

/** What is done, what the link tells, and where it stands at the end of it. */
const JOURNEYS: readonly [name: string, options: LinkBenchOptions, acts: readonly Act[], way: string][] = [
  ['a timer that answers', {}, [connect], 'opening > searching > on'],
  ['a port from the chooser', { plug: { granted: false } }, [choose], 'choosing > opening > searching > on'],
  ['a chooser that is dismissed', {}, [({ serial }) => serial.choose(null), choose], 'choosing > off (nothing-chosen)'],
  ['a browser without Web Serial', { link: { serial: undefined } }, [choose], 'off (unsupported)'],
  ['a timer that sleeps', {}, [sleep, connect, wait(5000), press, wait(2000)], 'opening > searching > waiting > on'],
  [
    'a port that another program holds for a while',
    BUSY,
    [begin, wait(5000), release, wait(2000)],
    'opening > searching > on',
  ],
  ['a port that another program holds', BUSY, [connect], 'opening > off (busy)'],
  ['a port that is not plugged in', {}, [unplug, connect], 'opening > off (unplugged)'],
  [
    'a port that is unplugged while another program holds it',
    BUSY,
    [begin, wait(2500), unplug, wait(0)],
    'opening > off (unplugged)',
  ],
  [
    'settings that the port does not take',
    {},
    [(bench) => bench.connect(bench.port, NO_SUCH_RATE)],
    'opening > off (bad-settings)',
  ],
  ['something that answers and is no timer', {}, [meetNonsense(true)], 'opening > searching > off (bad-reply)'],
  [
    'something that wakes and is no timer',
    {},
    [meetNonsense(false), wait(5000)],
    'opening > searching > waiting > off (bad-reply)',
  ],
  [
    'a port that is snatched between two rates',
    { answersAt: 19200 },
    [snatch, begin, wait(5000), isOpening, release, wait(5000)],
    'opening > searching > opening > searching > on',
  ],
  [
    'a port that is snatched while it is waited for',
    {},
    [sleep, connect, snatch, wait(10_000), isOpening, release, press, wait(5000)],
    'opening > searching > waiting > opening > searching > on',
  ],
  [
    'a cable that is pulled and plugged in again',
    {},
    [connect, unplug, wait(60_000), replug, wait(1000)],
    'opening > searching > on > away > opening > searching > on',
  ],
  [
    'a cable that returns as another port',
    {},
    [connect, unplug, wait(60_000), ({ adapter }) => adapter.returnAsNew(), wait(1000)],
    'opening > searching > on > away > opening > searching > on',
  ],
  [
    'a cable that is pulled while rates are tried',
    { plug: { timing: true } },
    [sleep, begin, wait(2000), unplug, wait(1000)],
    'opening > searching > away',
  ],
  [
    'a cable that is pulled while the timer is waited for',
    {},
    [sleep, connect, wait(2500), unplug, wait(1000)],
    'opening > searching > waiting > away',
  ],
  [
    'a cable that is pulled again while the port is opened again',
    {},
    [connect, unplug, wait(1000), hold, replug, wait(2500), unplug, wait(1000)],
    'opening > searching > on > away > opening > away',
  ],
  [
    'a stream that fails with its plug in',
    {},
    [connect, fail, wait(1000)],
    'opening > searching > on > away > opening > searching > on',
  ],
  [
    'a stream that fails before its plug is seen to be out',
    {},
    [connect, fail, wait(50), unplug, wait(1000)],
    'opening > searching > on > away',
  ],
  [
    'a port that fails whenever it is open',
    {},
    [
      (bench) => {
        bench.port.device.onopenchange = (opened) => opened && fail(bench);
      },
      begin,
      wait(60_000),
    ],
    `${'opening > searching > away > '.repeat(6)}off (lost)`,
  ],
  [
    'a timer that falls silent and answers again',
    {},
    [connect, sleep, ({ link }) => link.wait(), wait(3000), press, wait(2000)],
    'opening > searching > on > waiting > on',
  ],
  [
    'another timer in the place of the first',
    {},
    [
      connect,
      ({ timer }) => Object.assign(timer.core.identity, { firmware: '537' }),
      ({ clock, link }) => clock.run(link.recheck()),
      wait(0),
    ],
    'opening > searching > on > searching > on',
  ],
  [
    'a pilot who stops the chooser',
    { link: { serial: slowChooser() } },
    [({ link }) => void link.choose(), stop],
    'choosing > off',
  ],
  ['a pilot who stops the opening', BUSY, [begin, wait(2500), stop], 'opening > closing > off'],
  ['a pilot who stops the search', {}, [sleep, begin, wait(2000), stop], 'opening > searching > closing > off'],
  [
    'a pilot who stops the waiting',
    {},
    [sleep, connect, wait(2000), stop],
    'opening > searching > waiting > closing > off',
  ],
  ['a pilot who is done', {}, [connect, stop], 'opening > searching > on > closing > off'],
  [
    'a pilot who gives up a port that is away',
    {},
    [connect, unplug, wait(1000), stop],
    'opening > searching > on > away > closing > off',
  ],
  [
    'a pilot who connects again without stopping',
    {},
    [connect, connect],
    'opening > searching > on > closing > opening > searching > on',
  ],
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

  it.each(JOURNEYS)('%s', async (_, options, acts, expected) => {
    const bench = linkBench(options);
    const { states, clock, link, adapter } = bench;
    for (const act of acts) await act(bench);
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
