import { describe, expect, expectTypeOf, it } from 'vitest';
import { TimerClient, TimerError } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import { VirtualTimer } from '../../src/simulator/index.js';
import { answering, bench, names } from './bench.js';

describe('one request', () => {
  it('gives the values of its reply, typed by its name', async () => {
    const { client, timer, run } = bench();
    const { times } = await run(client.request({ name: 'GETTIMERS' }));
    expectTypeOf(times).toEqualTypeOf<readonly number[]>();
    expect(times).toEqual(timer.core.content.times);
    await run(client.request({ name: 'SETSERVO', servo: 0, function: 2, position: 41 }));
    expect(timer.core.content.positions[0]?.[2]).toBe(41);
  });

  it('needs two answers that agree where one cannot be believed', async () => {
    let lost = 1;
    const { client, timer, run } = bench({ fromTimer: { fault: (byte) => (lost-- > 0 ? [0xff] : [byte]) } });
    await run(client.identify());
    timer.core.answered.length = 0;
    await run(client.request({ name: 'GETMEMORY' }));
    expect(client.damageSeen).toBe(true);
    expect(names(timer.core.answered)).toEqual(['GETMEMORY', 'GETMEMORY']);
  });

  it('is sent once when it stores something, also where one answer is not believed', async () => {
    let lost = 1;
    const { client, timer, run } = bench({ fromTimer: { fault: (byte) => (lost-- > 0 ? [0xff] : [byte]) } });
    await run(client.identify());
    timer.core.answered.length = 0;
    await run(client.request({ name: 'SETSERVO', servo: 0, function: 2, position: 41 }));
    expect(names(timer.core.answered)).toEqual(['SETSERVO']);
  });

  it.each([
    ['a value that no timer can carry', { name: 'SETSERVO', servo: 0, function: 2, position: 131 }, 'out-of-range'],
    ['no command', { name: 'GETNOTHING' }, 'unknown-command'],
    ['nothing', undefined, 'unknown-command'],
  ])('is refused before anything is sent: %s', async (_, request, code) => {
    const { client, timer, run } = bench();
    await expect(run(client.request(request as never))).rejects.toMatchObject({ name: 'CodecError', code });
    expect(names(timer.core.answered)).not.toContain('SETSERVO');
  });
});

describe('a port that somebody else holds', () => {
  it.each(['readable', 'writable'] as const)(
    'says busy while its %s is locked, and works when it is not',
    async (side) => {
      const { client, timer, run } = bench();
      const other = side === 'readable' ? timer.readable.getReader() : timer.writable.getWriter();
      const message = `somebody else ${side === 'readable' ? 'reads from' : 'writes to'} the port and holds its lock`;
      await expect(run(client.identify())).rejects.toMatchObject({ name: 'TimerError', code: 'busy', message });
      expect(timer.core.answered).toEqual([]);
      other.releaseLock();
      expect(await run(client.identify())).toMatchObject({ firmware: timer.core.identity.firmware });
    },
  );

  it('says busy when somebody else writes in the middle, and sends nothing more', async () => {
    const { client, timer, run } = bench();
    await run(client.identify());
    const other = timer.writable.getWriter();
    timer.core.answered.length = 0;
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'busy' });
    other.releaseLock();
    expect(timer.core.answered).toEqual([]);
    expect(await run(client.readProgram())).toMatchObject({ memory: timer.core.memory });
  });
});

describe('the idle throttle', () => {
  it('is set, and read back twice', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    await run(client.identify());
    timer.core.answered.length = 0;
    expect(await run(client.setIdleThrottle(44))).toBe(44);
    const version = 'GETSWVER';
    expect(names(timer.core.answered)).toEqual([version, 'SETLOWRPM', version, 'GETLOWRPM', 'GETLOWRPM', version]);
  });

  it('is not reported as set when the timer does not say what it holds', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    answering(timer, 'GETLOWRPM', () => []);
    await expect(run(client.setIdleThrottle(44))).rejects.toMatchObject({
      code: 'bad-reply',
      details: { request: 'GETLOWRPM' },
    });
  });
});

describe('what a client hands out', () => {
  it('cannot be changed, so what it knows of the timer stays as it is', async () => {
    const { client, timer, run } = bench();
    const handed = [await run(client.identify()), client.identity, (await run(client.readProgram())).identity];
    for (const identity of handed) {
      expect(Reflect.set(identity ?? {}, 'functions', 1)).toBe(false);
      expect(Reflect.deleteProperty(identity ?? {}, 'servos')).toBe(false);
    }
    expect(client.identity).toEqual(timer.core.identity);
    expect(await run(client.readProgram())).toMatchObject({ times: timer.core.content.times });
  });

  it('is closed at the end of an `await using` block', async () => {
    const clock = new VirtualClock();
    const timer = new VirtualTimer({ clock });
    const client = new TimerClient(timer, { clock });
    await clock.run(client.identify());
    expect(timer.readable.locked).toBe(true);
    await client[Symbol.asyncDispose]();
    expect(timer.readable.locked).toBe(false);
    await expect(clock.run(client.identify())).rejects.toBeInstanceOf(TimerError);
  });
});

describe('a client', () => {
  it.each([Number.NaN, -1, '600'] as number[])('is not made with a rate or a margin of %s', (value) => {
    const port = new VirtualTimer();
    for (const field of ['baudRate', 'margin']) {
      expect(() => new TimerClient(port, { [field]: value })).toThrow(
        expect.objectContaining({
          code: 'out-of-range',
          field,
          message: `${field} must be a number of at least 0`,
          details: { value },
        }),
      );
    }
  });

  it('may be made with 0 for both: a line without a speed, and a timer without a delay', () => {
    expect(new TimerClient(new VirtualTimer(), { baudRate: 0, margin: 0 }).margin).toBe(0);
  });
});
