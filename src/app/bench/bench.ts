import { batch, computed, signal } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { ServoStand, type StandParts } from './servo-stand.js';

/** Actions of the bench that may move something. */
export type BenchAction = { readonly kind: 'move'; readonly slot: number } | { readonly kind: 'unlock' | 'jump' };

/**
 * What is known about the last action: the timer acknowledged it, or it may have happened without an acknowledgement.
 */
export interface Done {
  readonly action: BenchAction;
  readonly certain: boolean;
}

export type BenchParts = StandParts & Pick<Session, 'runner' | 'safety' | 'servoMoves'>;

/** Moves servos and motor from the page: only what the pilot asks for, one command at a time. */
export class Bench {
  /** The last action on the timer that is connected. Only this model writes it. */
  readonly done = signal<Done | null>(null);
  readonly stand: ServoStand;
  /** Whether an action may start: the timer does nothing else, and the pilot has said that it is safe. */
  readonly ready = computed(() => {
    const { runner, safety, onScreen } = this.#parts;
    // The servos move as the memory says that flies next, not as another one on the screen does.
    return runner.ready.value && !runner.claimed.value && safety.confirmed.value && !onScreen.apart.value;
  });
  readonly #parts: BenchParts;

  constructor(parts: BenchParts) {
    this.#parts = parts;
    this.stand = new ServoStand(parts);
    parts.connection.subscribe(() => {
      // A doubtful result is shown until the next action, because the timer may come back before anybody reads it.
      if (this.done.peek()?.certain) this.done.value = null;
    });
    parts.safety.confirmed.subscribe((safe) => {
      // A command that waits for its turn is no longer sent.
      if (!safe && parts.runner.job.peek()?.kind === 'bench') void parts.runner.stop();
    });
    parts.servoMoves.count.subscribe(() => {
      batch(() => {
        this.done.value = null;
        this.stand.lose();
      });
    });
  }

  /** Moves the servos to a slot, from 0 (start) to NF (DT). @returns whether the timer has acknowledged it. */
  async moveTo(slot: number): Promise<boolean> {
    return await this.#act({ kind: 'move', slot });
  }

  /** Frees the motor of a class Q timer. A propeller may start. */
  async unlock(): Promise<boolean> {
    return this.#parts.editor.working.value?.identity.timerClass === 'Q' && (await this.#act({ kind: 'unlock' }));
  }

  /** Sends the jump, whose effect is not documented. */
  async jump(): Promise<boolean> {
    return await this.#act({ kind: 'jump' });
  }

  /** Sends the action once, within a job, and notes what is known about it then. */
  async carryOut(action: BenchAction, connection: TimerConnection, options: JobContext): Promise<void> {
    const { client } = connection;
    options.stillOn();
    // The servos are moving now, unless they stand at that slot already.
    if (action.kind !== 'move' || action.slot !== this.stand.at.peek()) this.stand.lose();
    try {
      if (action.kind === 'move') await client.moveToFunction(action.slot, options);
      else if (action.kind === 'unlock') await client.unlockMotor(options);
      else await client.jump(options);
    } catch (error) {
      const isSent = error instanceof TimerError && (error.code === 'port-lost' || (error.details.sent ?? 0) > 0);
      this.stand.lose();
      if (isSent) this.done.value = { action, certain: false };
      throw error;
    }
    // The pilot may have disconnected meanwhile: it has happened all the same.
    batch(() => {
      this.done.value = { action, certain: true };
      if (action.kind === 'move') this.stand.moved(connection, action.slot);
    });
  }

  async #act(action: BenchAction): Promise<boolean> {
    if (!this.ready.value) return false;
    this.done.value = null;
    return await this.#parts.runner.run('bench', (connection, options) => this.carryOut(action, connection, options));
  }
}
