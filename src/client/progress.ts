import { type CommandName, exchangeSize, type Identity } from '../protocol/index.js';

/** How far a job has come, in bytes of the line, so that it moves as evenly as the line does. */
export interface Progress {
  readonly stage: 'read' | 'write' | 'verify' | 'repair';
  readonly done: number;
  readonly total: number;
}

/** Counts one stage of a job. Repeats do not count: the bar waits. */
export class StageProgress {
  readonly #stage: Progress['stage'];
  readonly #identity: Identity;
  readonly #total: number;
  readonly #report: ((progress: Progress) => void) | undefined;
  #done = 0;

  constructor(
    stage: Progress['stage'],
    requests: readonly CommandName[],
    identity: Identity,
    report: ((progress: Progress) => void) | undefined,
  ) {
    this.#stage = stage;
    this.#identity = identity;
    this.#report = report;
    this.#total = requests.reduce((sum, name) => sum + this.#size(name), 0);
    report?.({ stage, done: 0, total: this.#total });
  }

  finished(name: CommandName): void {
    this.#done = Math.min(this.#total, this.#done + this.#size(name));
    this.#report?.({ stage: this.#stage, done: this.#done, total: this.#total });
  }

  #size(name: CommandName): number {
    const { request, reply } = exchangeSize(name, this.#identity);
    return request + reply;
  }
}
