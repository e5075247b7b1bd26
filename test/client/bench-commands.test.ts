import { describe, expect, it } from 'vitest';
import { bench } from './bench.js';

describe('one position', () => {
  it('is stored by one SETSERVO', async () => {
    const { client, timer, run } = bench();
    await run(client.identify());
    timer.core.answered.length = 0;
    await run(client.setPosition({ servo: 1, slot: 4 }, 70));
    expect(timer.core.answered).toEqual([{ name: 'SETSERVO', servo: 1, function: 4, position: 70 }]);
    expect(timer.core.content.positions[1]?.[4]).toBe(70);
  });

  it('is sent again when its answer is lost, because that does no harm', async () => {
    let lost = 0;
    const { client, timer, run } = bench({ fromTimer: { fault: (byte) => (lost-- > 0 ? [] : [byte]) } });
    await run(client.identify());
    lost = 9;
    await run(client.setPosition({ servo: 0, slot: 2 }, 40));
    const sent = timer.core.answered.filter(({ name }) => name === 'SETSERVO');
    expect([sent.length, timer.core.content.positions[0]?.[2]]).toEqual([2, 40]);
  });

  it.each([
    [3, 4, 70, 'servo'],
    [1, 11, 70, 'function'],
    [1, 4, 131, 'position'],
  ])('is refused before anything is sent: servo %i, slot %i, position %i', async (servo, slot, position, field) => {
    const { client, timer, run } = bench();
    await run(client.identify());
    timer.core.answered.length = 0;
    await expect(run(client.setPosition({ servo, slot }, position))).rejects.toMatchObject({
      name: 'CodecError',
      code: 'out-of-range',
      field,
    });
    expect(timer.core.answered).toEqual([]);
  });
});
