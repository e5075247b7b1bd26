import { describe, expect, it } from 'vitest';
import type { TimerClient } from '../../src/client/index.js';
import { answers, type Bytes, decodeReply, FrameDecoder, type Request } from '../../src/protocol/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';
import { toHex } from '../tools/bytes.js';
import { shareOf } from '../tools/share.js';
import { type Bench, bench, contentOf, edited } from './bench.js';

const SMALL = { functions: 2, memories: 2, servos: 1 };

describe('a reply of which two bits are flipped, or two bytes changed, and the sum is right', () => {
  /**
   * Its idle throttle makes a sum that is one bit away from the bare letter of the command, which is taken for a sum
   * too.
   */
  function field(): Bench {
    const made = bench({ identity: { ...SMALL, timerClass: 'Q' } });
    made.timer.core.idleThrottle = 8;
    return made;
  }

  /** A reply that came, and the request that it belongs to. */
  interface Heard {
    readonly request: Request;
    readonly bytes: Uint8Array;
  }

  /** Lets one reply come damaged, counted from now on. */
  function damage(timer: VirtualTimer, hit: number, damaged: Uint8Array): void {
    const answer = timer.core.answer.bind(timer.core);
    let count = 0;
    timer.core.answer = (frame, bare) => {
      const bytes = answer(frame, bare);
      return count++ === hit ? Uint8Array.from(damaged) : bytes;
    };
  }

  /** All replies to a job. */
  async function heard(work: (client: TimerClient) => Promise<unknown>): Promise<Heard[]> {
    const { client, timer, run } = field();
    await run(client.identify());
    const answer = timer.core.answer.bind(timer.core);
    const found: Heard[] = [];
    timer.core.answer = (frame, bare) => {
      const bytes = answer(frame, bare) as Bytes;
      found.push({ request: timer.core.answered.at(-1) as Request, bytes });
      return bytes;
    };
    await run(work(client));
    return found;
  }

  /** Whether a client that waits for this reply finds nothing wrong with these bytes. */
  function passes({ core }: VirtualTimer, pending: Request, bytes: Uint8Array): boolean {
    const decoder = new FrameDecoder({ quirks: { bareChecksum: pending.name === 'GETLOWRPM' } });
    return [...decoder.push(bytes), ...decoder.idle()].some((frame) => {
      try {
        return answers(frame.code, pending.name) && decodeReply(frame, { identity: core.identity, pending });
      } catch {
        return false;
      }
    });
  }

  /**
   * All that damage can make of a reply without a trace: two bits flipped anywhere, or two bytes moved by one amount.
   */
  function* damagedReplies(timer: VirtualTimer, { request, bytes }: Heard): Generator<Uint8Array> {
    const seen = new Set<string>([bytes.join()]);
    function* isNew(damaged: Uint8Array): Generator<Uint8Array> {
      if (seen.has(damaged.join()) || !passes(timer, request, damaged)) return;
      seen.add(damaged.join());
      yield damaged;
    }
    for (let one = 0; one < 8 * bytes.length; one++) {
      for (let two = one + 1; two < 8 * bytes.length; two++) {
        const damaged = Uint8Array.from(bytes);
        for (const bit of [one, two]) damaged[bit >> 3] = (damaged[bit >> 3] as number) ^ (1 << (bit & 7));
        yield* isNew(damaged);
      }
    }
    const sum = bytes.length - 2;
    for (let one = 6; one < sum; one++) {
      for (let two = one + 1; two <= sum; two++) {
        for (const amount of [2, 16]) {
          const damaged = Uint8Array.from(bytes);
          damaged[one] = (damaged[one] as number) + amount;
          damaged[two] = (damaged[two] as number) + (two === sum ? amount : -amount);
          yield* isNew(damaged);
        }
      }
    }
  }

  /** Lets a client do a job with each reply to it damaged in each way. It finds nothing about the timer by that. */
  async function* damagedJobs<T>(job: (client: TimerClient) => Promise<T>) {
    let cases = 0;
    for (const [hit, reply] of (await heard(job)).entries()) {
      const damagedWays = [...damagedReplies(field().timer, reply)];
      cases += damagedWays.length;
      for (const damaged of shareOf(damagedWays)) {
        const { client, timer, run } = field();
        await run(client.identify());
        damage(timer, hit, damaged);
        const result = await run(job(client));
        const { name } = reply.request;
        const label = `${name}: ${toHex(damaged)}`;
        expect([client.quirksFound.size, client.quirksAssumed], label).toEqual([0, {}]);
        yield { result, content: contentOf(timer), name, damaged, label };
      }
    }
    expect(cases).toBeGreaterThan(100);
  }

  it('of a reading: timer, memory and how memories are counted are right, or it is refused', async () => {
    for await (const { result, content, name, damaged, label } of damagedJobs((client) => client.readProgram())) {
      expect([result.identity, result.memory], label).toEqual([content.identity, content.memory]);
      // The values of a single reading are all that can be wrong: a plain reading believes it on a good line.
      const isContent = ['GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM'].includes(name);
      const isBare = new FrameDecoder().push(damaged).length === 0;
      if (!isContent || isBare) expect(result, label).toEqual(content);
    }
  });

  it('of a write: it is verified when, and only when, the timer holds the goal', async () => {
    const baseline = structuredClone(contentOf(field().timer));
    const goal = edited(baseline, [2, 9000], [0, 1, 77]);
    for await (const { result, content, label } of damagedJobs((client) => client.writeProgram(goal, { baseline }))) {
      expect([result.result, content], label).toEqual(['verified', goal]);
    }
  });
});
