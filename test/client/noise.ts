/** Numbers from 0 up to 1, always the same for one seed (mulberry32). */
export function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** A line that damages this share of all bytes: lost, changed to any other value, or doubled, each as often. */
export function damage(share: number, random: () => number): (byte: number) => number[] {
  return (byte) => {
    if (random() >= share) return [byte];
    const kind = Math.floor(3 * random());
    if (kind === 0) return [];
    return kind === 1 ? [byte ^ (1 + Math.floor(255 * random()))] : [byte, byte];
  };
}
