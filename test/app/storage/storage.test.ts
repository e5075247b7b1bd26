import { describe, expect, it, vi } from 'vitest';
import { type AppBench, connectedBench, MemoryStore, reloaded, run } from '../bench/bench.js';

/** The rates at which the port was opened, by the test's own order: each question is one line of the log. */
function asked({ session }: AppBench): number {
  return session.log.entries.value.filter(({ direction, frame }) => direction === 'out' && frame?.code === 0x6b).length;
}

describe('what is remembered of a port', () => {
  it('is what was assumed of its timers, and the next one gets the same assumptions', async () => {
    const before = await connectedBench();
    expect(before.session.connection.value?.client.quirksAssumed).toEqual({});
    await run(before.session.timer.assume({ bigEndianTimes: true }));
    const after = await reloaded(before);
    let first: unknown;
    after.session.connection.subscribe((connection) => {
      first ??= connection && { ...connection.client.quirksAssumed };
    });
    await run(after.session.timer.connect());
    expect(first).toEqual({ bigEndianTimes: true });
  });

  it('includes what a job has found out', async () => {
    const before = await connectedBench({ quirks: { memoriesFromOne: true } });
    expect(before.session.connection.value?.client.quirksAssumed).toEqual({});
    before.timer.core.memory = 3;
    await run(before.session.reader.read());
    expect(before.session.connection.value?.client.quirksAssumed).toEqual({ memoriesFromOne: true });
    const [record] = before.store.ports.records.values();
    expect(Object.values(record?.quirks ?? {})).toEqual([{ memoriesFromOne: true }]);
  });

  it('is stored again only when a job has found something', async () => {
    const bench = await connectedBench();
    const saved = vi.spyOn(bench.store.ports, 'save');
    await run(bench.session.reader.read());
    await run(bench.session.reader.selectMemory(1));
    expect(saved).not.toHaveBeenCalled();
  });

  it('does not apply to another kind of timer', async () => {
    const before = await connectedBench();
    await run(before.session.timer.assume({ bigEndianTimes: true }));
    const after = await connectedBench({ store: before.store, identity: { timerClass: 'B' } });
    expect(after.session.connection.value?.client.quirksAssumed).toEqual({});
  });

  it('does not include a simulated timer', async () => {
    const bench = await connectedBench();
    await run(bench.session.timer.disconnect());
    bench.store.ports.records.clear();
    await run(bench.session.timer.trySimulated('Q'));
    await run(bench.session.timer.assume({ bigEndianTimes: true }));
    expect(bench.store.ports.records.size).toBe(0);
  });

  it('includes the rate at which a timer answered, which is tried first', async () => {
    const bench = await connectedBench({ answersAt: 19_200 });
    expect(bench.session.connection.value?.settings.baudRate).toBe(19_200);
    expect(asked(bench)).toBeGreaterThan(3);
    expect([...bench.store.ports.records.values()]).toMatchObject([
      { foundRate: 19_200, settings: { baudRate: 'find' } },
    ]);

    const after = await connectedBench({ store: bench.store, answersAt: 19_200 });
    expect(after.session.connection.value?.settings.baudRate).toBe(19_200);
    // Once to find it, once after the reading.
    expect(asked(after)).toBe(2);
  });

  it('is forgotten with the port', async () => {
    const bench = await connectedBench({ answersAt: 19_200 });
    await run(bench.session.timer.disconnect());
    const [port] = bench.session.link.ports.value;
    if (!port) throw new Error('no port is known');
    await run(bench.session.link.forget(port));
    expect([bench.session.link.ports.value, bench.store.ports.records.size]).toEqual([[], 0]);
    expect(bench.session.link.recordOf(port.key)).toBeUndefined();
  });

  it('is not needed: a browser that keeps nothing can still connect', async () => {
    const store = new MemoryStore();
    store.broken = true;
    const bench = await connectedBench({ store, answersAt: 19_200 });
    expect(bench.session.connection.value?.settings.baudRate).toBe(19_200);
    await run(bench.session.timer.disconnect());
    bench.session.log.clear();
    await run(bench.session.timer.connect());
    expect(asked(bench), 'the page remembers the speed although nothing is stored').toBe(2);
  });
});
