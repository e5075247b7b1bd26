import { computed, signal } from '@preact/signals';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { type ServosAtHand, ServoUses } from '../../../src/app/work/servo-uses.js';
import type { ServoUse } from '../../../src/program/index.js';

const TAILPLANE: ServoUse = { duty: 'tailplane', name: '', low: 20, high: 95, reversed: false };
const FLAP: ServoUse = { duty: 'other', name: 'Flap', low: 0, high: 130, reversed: false };

/** Freshly opened, with a timer of this kind at hand. */
function opened(kind = 'timer/Q') {
  const atHand = signal<ServosAtHand | null>({ kind, servos: 2 });
  return { atHand, uses: new ServoUses(atHand) };
}

afterEach(() => {
  vi.unstubAllGlobals();
  localStorage.clear();
});

describe('what the servos move', () => {
  it('is not known until the pilot says it, and is then kept for timers of this kind', () => {
    const { uses } = opened();
    expect(uses.named.value).toBeNull();
    uses.say([TAILPLANE, FLAP]);
    expect(uses.named.value).toEqual([TAILPLANE, FLAP]);
    expect(opened().uses.named.value).toEqual([TAILPLANE, FLAP]);
    expect(opened('timer/B').uses.named.value).toBeNull();
  });

  it('follows the timer on the screen', () => {
    const { atHand, uses } = opened();
    uses.say([TAILPLANE, FLAP]);
    atHand.value = { kind: 'timer/B', servos: 2 };
    expect(uses.named.value).toBeNull();
    atHand.value = null;
    expect(uses.named.value).toBeNull();
    uses.say([FLAP, FLAP]);
    atHand.value = { kind: 'timer/Q', servos: 2 };
    expect(uses.named.value, 'a name that is given while there is no timer is not kept').toEqual([TAILPLANE, FLAP]);
  });

  it('belongs to the model when that is known, and only then', () => {
    const atHand = signal<ServosAtHand | null>({ kind: 'timer/Q', servos: 2 });
    const servos = signal<readonly ServoUse[] | null>(null);
    const say = (said: readonly ServoUse[]): void => {
      servos.value = said;
    };
    const ofModel = computed(() => servos.value && { servos: servos.value, say });
    const uses = new ServoUses(atHand, ofModel);
    uses.say([TAILPLANE, FLAP]);
    servos.value = [];
    expect(uses.named.value, 'the model has no names, so those of the kind of timer are used').toEqual([
      TAILPLANE,
      FLAP,
    ]);
    uses.say([FLAP, FLAP]);
    expect([servos.value, uses.named.value]).toEqual([
      [FLAP, FLAP],
      [FLAP, FLAP],
    ]);
    expect(opened().uses.named.value, 'the names for the kind of timer have not changed').toEqual([TAILPLANE, FLAP]);
    servos.value = [FLAP];
    expect(uses.named.value, 'the model has another number of servos, so its names are not used').toEqual([
      TAILPLANE,
      FLAP,
    ]);
    uses.say(null);
    expect([servos.value, uses.named.value]).toEqual([[], null]);
  });

  it('can be taken back, to be guessed again', () => {
    const { uses } = opened();
    uses.say([TAILPLANE, FLAP]);
    uses.say(null);
    expect(uses.named.value).toBeNull();
    expect(opened().uses.named.value).toBeNull();
  });

  it('holds for this page where the browser keeps nothing', () => {
    vi.stubGlobal('localStorage', {
      getItem: () => null,
      setItem: () => {
        throw new DOMException('No room.', 'QuotaExceededError');
      },
    });
    const { uses } = opened();
    uses.say([TAILPLANE, FLAP]);
    expect(uses.named.value).toEqual([TAILPLANE, FLAP]);
    expect(opened().uses.named.value).toBeNull();
  });

  it.each([
    ['', 'no text'],
    ['{', 'broken'],
    ['{"duty":"wing"}', 'no list'],
    [JSON.stringify([TAILPLANE]), 'fewer servos'],
    [JSON.stringify([TAILPLANE, FLAP, FLAP]), 'more servos'],
    [JSON.stringify([TAILPLANE, { ...FLAP, high: 131 }]), 'past the last step'],
    [JSON.stringify([TAILPLANE, { ...FLAP, duty: 'flap' }]), 'an unknown duty'],
    [JSON.stringify([TAILPLANE, { ...FLAP, name: 'x'.repeat(17) }]), 'a name that is too long'],
  ])('is not known when the stored value is impossible: %s (%s)', (text) => {
    localStorage.setItem('sidus-timer/servos/timer/Q', text);
    expect(opened().uses.named.value).toBeNull();
  });
});
