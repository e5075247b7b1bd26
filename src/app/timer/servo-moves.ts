import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { WriteReport } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Safety } from './safety.js';

/**
 * Whether a write may move the servos, for timers that keep positions only where the servos stand.
 * Asked again for each write.
 */
export class ServoMoves {
  readonly #allowed = signal(false, { name: 'moveServos' });
  readonly #count = signal(0, { name: 'servoMoves' });
  /** Whether the pilot agrees that the servos move to each function before its positions are stored. */
  readonly allowed: ReadonlySignal<boolean> = this.#allowed;
  /**
   * Goes up each time that something other than the bench may have moved the servos: their place is not known since.
   */
  readonly count: ReadonlySignal<number> = this.#count;
  readonly #connection: ReadonlySignal<TimerConnection | null>;
  readonly #safety: Safety;

  constructor(connection: ReadonlySignal<TimerConnection | null>, safety: Safety) {
    this.#connection = connection;
    this.#safety = safety;
  }

  /** Whether the connected timer seems to need it. */
  get needed(): boolean {
    return this.#connection.value?.client.quirksAssumed.positionsNeedMove === true;
  }

  /** Something is about to be sent that may move them, such as a frame by hand. */
  mayMove(): void {
    this.#count.value++;
  }

  /** Another write is about to be shown. */
  ask(): void {
    this.#allowed.value = false;
  }

  /** The pilot agrees, or no longer agrees. */
  allow(agrees: boolean): void {
    this.#allowed.value = agrees;
  }

  /**
   * A write begins.
   * @returns whether it may move the servos.
   */
  take(): boolean {
    const isAllowed = this.#allowed.value && this.needed && this.#safety.confirmed.value;
    batch(() => {
      this.#allowed.value = false;
      if (isAllowed) this.mayMove();
    });
    return isAllowed;
  }

  /** Whether positions may not have been kept because no servo moved. */
  wanted(moved: boolean, reports: readonly WriteReport[]): boolean {
    const values = reports.flatMap((report) => report.values);
    const lost = values.some(({ field, asked, status }) => asked && field.kind === 'position' && status === 'differs');
    return lost && !moved && this.needed;
  }
}
