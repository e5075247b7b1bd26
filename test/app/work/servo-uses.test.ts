import { signal } from '@preact/signals';
import { describe, expect, it, vi } from 'vitest';
import { emptyModel } from '../../../src/app/records/library.js';
import { ServoUses } from '../../../src/app/work/servo-uses.js';
import type { Model, ServoUse } from '../../../src/program/index.js';

const TAILPLANE: ServoUse = { duty: 'tailplane', name: '', low: 20, high: 95, reversed: false };
const FLAP: ServoUse = { duty: 'other', name: 'Flap', low: 0, high: 130, reversed: false };

const timerOf = (timerClass: string) => ({ timerClass, firmware: '536', functions: 10, memories: 4, servos: 2 });

/** Freshly opened, with the program of a timer of this class on the screen, and of no known model. */
function opened(timerClass = 'Q') {
  const identity = signal<ReturnType<typeof timerOf> | null>(timerOf(timerClass));
  const named = signal<Model | null>(null);
  const changeModel = async (_: string, changed: Partial<Model>): Promise<void> => {
    named.value = named.value && { ...named.value, ...changed };
  };
  const parts = { editor: { identity }, onScreen: { simulated: signal(false) }, origin: { named } };
  return { identity, named, uses: new ServoUses({ ...parts, library: { changeModel } }) };
}

describe('what the servos move', () => {
  it('is not known until the pilot says it, and is then kept for timers of this kind', () => {
    const { uses } = opened();
    expect(uses.named.value).toBeNull();
    uses.say([TAILPLANE, FLAP]);
    expect(uses.named.value).toEqual([TAILPLANE, FLAP]);
    expect(opened().uses.named.value).toEqual([TAILPLANE, FLAP]);
    expect(opened('B').uses.named.value).toBeNull();
  });

  it('follows the timer on the screen', () => {
    const { identity, uses } = opened();
    uses.say([TAILPLANE, FLAP]);
    identity.value = timerOf('B');
    expect(uses.named.value).toBeNull();
    identity.value = null;
    expect(uses.named.value).toBeNull();
    uses.say([FLAP, FLAP]);
    identity.value = timerOf('Q');
    expect(uses.named.value, 'a name that is given while there is no timer is not kept').toEqual([TAILPLANE, FLAP]);
  });

  it('belongs to the model when that is known, and only then', () => {
    const { named, uses } = opened();
    const servos = () => named.value?.servos;
    uses.say([TAILPLANE, FLAP]);
    const lancer = emptyModel('lancer', 'Lancer', 'Q');
    named.value = lancer;
    expect(uses.named.value, 'the model has no names, so those of the kind of timer are used').toEqual([
      TAILPLANE,
      FLAP,
    ]);
    uses.say([FLAP, FLAP]);
    expect([servos(), uses.named.value]).toEqual([
      [FLAP, FLAP],
      [FLAP, FLAP],
    ]);
    expect(opened().uses.named.value, 'the names for the kind of timer have not changed').toEqual([TAILPLANE, FLAP]);
    named.value = { ...lancer, servos: [FLAP] };
    expect(uses.named.value, 'the model has another number of servos, so its names are not used').toEqual([
      TAILPLANE,
      FLAP,
    ]);
    uses.say(null);
    expect([servos(), uses.named.value]).toEqual([[], null]);
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
    ['{', 'broken'],
    ['{"duty":"wing"}', 'no list'],
    [JSON.stringify([TAILPLANE]), 'fewer servos'],
    [JSON.stringify([TAILPLANE, FLAP, FLAP]), 'more servos'],
    [JSON.stringify([TAILPLANE, { ...FLAP, high: 131 }]), 'past the last step'],
    [JSON.stringify([TAILPLANE, { ...FLAP, duty: 'flap' }]), 'an unknown duty'],
    [JSON.stringify([TAILPLANE, { ...FLAP, name: 'x'.repeat(17) }]), 'a name that is too long'],
  ])('is not known when the stored value is impossible: %s (%s)', (text) => {
    localStorage.setItem('sidus-timer/servos/timer/Q/536/10/2', text);
    expect(opened().uses.named.value).toBeNull();
  });
});
