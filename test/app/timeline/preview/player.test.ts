import { signal } from '@preact/signals';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Player, SPEEDS } from '../../../../src/app/timeline/preview/player.js';
import { HandFrames } from './hand-frames.js';

function bench(end = 18300) {
  const frames = new HandFrames();
  const player = new Player();
  player.setEnd(end);
  return { frames, player };
}

/** Starts it, and lets the first frame come, from which time counts. */
function started(end?: number) {
  const { frames, player } = bench(end);
  player.toggle();
  frames.run(1, 16);
  return { frames, player };
}

describe('a player', () => {
  it.each(SPEEDS)('runs %i times as fast as the flight', (speed) => {
    const { frames, player } = started();
    player.setSpeed(speed);
    frames.run(50, 20);
    expect(player.cursor.value).toBe(100 * speed);
  });

  it('loses no time, however short the frames are', () => {
    const { frames, player } = started();
    frames.run(1000, 1);
    expect([99, 100]).toContain(player.cursor.value);
  });

  it('pauses and goes on where it was, also after the page was hidden', () => {
    const { frames, player } = started();
    frames.run(10, 100);
    player.toggle();
    expect([player.playing.value, frames.waiting]).toEqual([false, 0]);
    frames.now += 60_000;
    player.toggle();
    frames.run(1, 16);
    expect(player.cursor.value).toBe(100);
    frames.run(10, 100);
    expect(player.cursor.value).toBe(200);
    frames.run(1, 3_600_000);
    expect(player.cursor.value).toBe(225);
  });

  it('stops at the end, and starts again at launch', () => {
    const { frames, player } = started(250);
    frames.run(40, 100);
    expect([player.cursor.value, player.playing.value, frames.waiting]).toEqual([250, false, 0]);
    player.toggle();
    expect([player.cursor.value, player.playing.value]).toEqual([0, true]);
  });

  it('never leaves the flight and never runs backwards by itself, whatever is done', () => {
    const action = fc.oneof(
      fc.record({ frames: fc.integer({ min: 1, max: 20 }), ms: fc.integer({ min: 0, max: 2000 }) }),
      fc.record({ seek: fc.integer({ min: -100, max: 20000 }) }),
      fc.record({ end: fc.integer({ min: 300, max: 20000 }) }),
      fc.record({ speed: fc.constantFrom(...SPEEDS) }),
      fc.constant({ toggle: true } as const),
    );
    fc.assert(
      fc.property(fc.array(action, { maxLength: 30 }), (actions) => {
        let end = 18300;
        const { frames, player } = bench(end);
        for (const one of actions) {
          const before = player.shown.value;
          if ('frames' in one) {
            frames.run(one.frames, one.ms);
            expect(player.shown.value).toBeGreaterThanOrEqual(before);
          } else if ('seek' in one) player.seek(one.seek);
          else if ('end' in one) {
            end = one.end;
            player.setEnd(end);
          } else if ('speed' in one) player.setSpeed(one.speed);
          else player.toggle();
          const { value } = player.shown;
          expect([Number.isInteger(value), value >= 0, value <= end]).toEqual([true, true, true]);
          expect(frames.waiting).toBe(player.playing.value ? 1 : 0);
        }
      }),
      { numRuns: 500 },
    );
  });
});

describe('the time that is shown', () => {
  it('is that of the selected cell, until the flight is played or stepped through', () => {
    const { frames, player } = bench();
    const seen = () => [player.shown.value, player.cursor.value];
    expect(seen()).toEqual([0, null]);
    player.take(1060);
    expect(seen()).toEqual([1060, null]);
    player.seek(400);
    expect(seen()).toEqual([400, 400]);
    player.toggle();
    frames.run(2, 100);
    expect(seen()).toEqual([410, 410]);
    player.pause();
    player.take(2000);
    expect(seen()).toEqual([2000, null]);
    player.toggle();
    frames.run(2, 100);
    expect(seen()).toEqual([2010, 2010]);
    player.take(30);
    expect(seen(), 'while the flight plays, a selection does not move it').toEqual([2010, 2010]);
    player.pause();
    expect(seen(), 'a paused flight stays where it is').toEqual([2010, 2010]);
  });

  it('is that of the pointer, as long as it points', () => {
    const asked = signal<number | null>(null);
    const player = new Player(asked);
    player.setEnd(18300);
    player.seek(400);
    asked.value = 120;
    expect([player.shown.value, player.cursor.value]).toEqual([120, 400]);
    asked.value = null;
    expect(player.shown.value).toBe(400);
  });

  it('is within the flight; played, it begins at launch where the selected cell is DT, after which nothing comes', () => {
    const { frames, player } = bench(18300);
    player.take(18000);
    player.setEnd(2300);
    expect(player.shown.value).toBe(2300);
    player.setEnd(18300);
    player.toggle();
    frames.run(2, 100);
    expect(player.cursor.value).toBe(10);
  });
});
