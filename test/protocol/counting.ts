import { FrameDecoder, type FrameDecoderOptions } from '../../src/protocol/index.js';

/** Bytes that were read, one by one or many at once. */
export interface Counter {
  visited: number;
}

/**
 * An array of bytes that counts what is read from it: each byte by index, and all bytes of a copy. It refuses methods
 * that it does not know, so that no reading goes uncounted.
 */
function counting(bytes: Uint8Array, counter: Counter): Uint8Array {
  const range = (from = 0, to = bytes.length): number => Math.max(0, to - from);
  const methods: Partial<Record<keyof Uint8Array, (...args: never[]) => unknown>> = {
    subarray(from?: number, to?: number) {
      counter.visited += range(from, to);
      return bytes.subarray(from, to);
    },
    slice(from?: number, to?: number) {
      counter.visited += range(from, to);
      return bytes.slice(from, to);
    },
    copyWithin(target: number, from: number, to?: number) {
      counter.visited += range(from, to);
      bytes.copyWithin(target, from, to);
      return proxy;
    },
    set(source: ArrayLike<number>, at?: number) {
      counter.visited += source.length;
      bytes.set(source, at);
    },
    indexOf(value: number, from?: number) {
      const found = bytes.indexOf(value, from);
      counter.visited += range(from, found < 0 ? bytes.length : found + 1);
      return found;
    },
  };
  const proxy: Uint8Array = new Proxy(bytes, {
    get(_, key) {
      const index = typeof key === 'string' ? Number(key) : Number.NaN;
      if (index >= 0) {
        counter.visited++;
        return bytes[index];
      }
      if (key === Symbol.toStringTag) return bytes[Symbol.toStringTag];
      if (key === 'length' || key === 'byteLength' || key === 'byteOffset') return bytes[key];
      const method = methods[key as keyof Uint8Array];
      if (!method) throw new Error(`counting.ts does not know how many bytes ${String(key)} reads`);
      return method;
    },
    set(_, key, value: number) {
      bytes[Number(key)] = value;
      return true;
    },
  });
  return proxy;
}

/** A decoder that counts the bytes it reads, in its chunks and in what it holds. */
export class CountedDecoder {
  readonly counter: Counter = { visited: 0 };
  readonly #decoder: FrameDecoder;

  constructor(options?: FrameDecoderOptions) {
    // The decoder makes its own array here, so that one counts, too.
    const { Uint8Array: plain } = globalThis;
    const { counter } = this;
    globalThis.Uint8Array = new Proxy(plain, {
      construct: (target, args) => counting(Reflect.construct(target, args) as Uint8Array, counter),
    });
    try {
      this.#decoder = new FrameDecoder(options);
    } finally {
      globalThis.Uint8Array = plain;
    }
  }

  /** @returns how many frames were delivered. */
  push(chunk: Uint8Array): number {
    return this.#decoder.push(counting(chunk, this.counter)).length;
  }

  idle(): number {
    return this.#decoder.idle().length;
  }
}
