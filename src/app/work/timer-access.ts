import { batch, type ReadonlySignal } from '@preact/signals';
import type { AssumedQuirks } from '../../client/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import type { LinkState, SerialPortLike, Surroundings } from '../../serial/index.js';
import type { Editor } from '../editing/editor.js';
import type { JobRunner } from '../timer/job-runner.js';
import type { Knowledge } from '../timer/knowledge.js';
import { type Link, portInfoOf } from '../timer/link.js';
import type { NextFlight } from '../timer/next-flight.js';
import type { Notices } from '../timer/notices.js';
import type { Trials } from '../timer/trials.js';
import type { InterruptedJobs } from './interrupted-jobs.js';
import type { OnScreen } from './on-screen.js';
import type { Reader } from './reader.js';

/** The classes for which there is a simulated timer. */
export const SIMULATED_CLASSES = ['Q', 'B', 'E'] as const;
export type SimulatedClass = (typeof SIMULATED_CLASSES)[number];

/** The sources of timers to which this page can connect. */
export interface TimerSources {
  readonly surroundings: Surroundings;
  readonly plugSimulated: (timerClass: SimulatedClass) => SerialPortLike | Promise<SerialPortLike>;
  readonly plugRecording: (entries: readonly CaptureEntry[]) => SerialPortLike | Promise<SerialPortLike>;
}

/** All that depends on which timer is there. */
interface AccessParts {
  readonly link: Link;
  readonly runner: JobRunner;
  readonly reader: Reader;
  readonly notices: Notices;
  readonly knowledge: Knowledge;
  readonly recovery: InterruptedJobs;
  readonly nextFlight: NextFlight;
  readonly trials: Trials;
  readonly editor: Pick<Editor, 'identity'>;
  readonly onScreen: Pick<OnScreen, 'simulated'>;
  readonly engaged: ReadonlySignal<boolean>;
}

/** Connects and disconnects: one connection at a time, also while it waits for a timer. */
export class TimerAccess {
  readonly #parts: AccessParts;
  readonly #sources: TimerSources;
  /** Whether there was a simulated timer in this page: each keeps what it holds until the page is closed. */
  #hasSimulated = false;

  constructor(parts: AccessParts, sources: TimerSources) {
    this.#parts = parts;
    this.#sources = sources;
    parts.link.onState((state, before) => this.#follow(state, before));
  }

  /**
   * Connects to the port that was used last, or to the only known one; otherwise the pilot chooses a port. A connected
   * timer that was not read is read.
   * @param choose asks for a port in any case.
   * @returns once the timer is read, or has to be waited for.
   */
  async connect(choose = false): Promise<void> {
    const { engaged, link, reader } = this.#parts;
    if (!this.#sources.surroundings.serial || engaged.value) return;
    if (link.connection.value && !choose) return void (await reader.read());
    await this.#goTo(async () => {
      await link.refresh();
      const [first, ...more] = choose ? [] : link.ports.value;
      const sure = first && (more.length === 0 || link.recordOf(first.key));
      return sure ? first.port : null;
    });
  }

  /** Connects to one of the known ports. */
  async connectTo(port: SerialPortLike): Promise<void> {
    await this.#goTo(async () => port);
  }

  async trySimulated(timerClass: SimulatedClass): Promise<void> {
    const { recovery, trials, link } = this.#parts;
    await this.#goTo(async () => {
      if (!this.#hasSimulated) {
        trials.forgetSimulated();
        await recovery.forgetSimulated();
      }
      this.#hasSimulated = true;
      return link.simulate(await this.#sources.plugSimulated(timerClass));
    });
  }

  /** Connects to a timer that replays a recording. */
  async tryRecording(entries: readonly CaptureEntry[]): Promise<void> {
    await this.#goTo(async () => this.#parts.link.simulate(await this.#sources.plugRecording(entries)));
  }

  /** The simulated timer from which the program on the screen came; undefined when it came from another one. */
  get simulated(): SimulatedClass | undefined {
    const { onScreen, editor } = this.#parts;
    const timerClass = onScreen.simulated.value ? editor.identity.value?.timerClass : undefined;
    return SIMULATED_CLASSES.find((each) => each === timerClass);
  }

  /** Whether the program on the screen came from a simulated timer that still holds what was written to it. */
  get holdsSimulated(): boolean {
    return this.simulated !== undefined && this.#hasSimulated;
  }

  /** Connects to a timer like the one from which the program on the screen came. */
  async comeBack(): Promise<void> {
    const { simulated } = this;
    await (simulated ? this.trySimulated(simulated) : this.connect());
  }

  /**
   * Lets the pilot choose another port while the link waits for a timer on this one.
   * The wait goes on until a port is chosen.
   */
  async chooseAnother(): Promise<void> {
    const { link, reader } = this.#parts;
    if (!['searching', 'waiting'].includes(link.state.value.status)) return;
    await link.choose();
    await reader.settled();
  }

  /**
   * Stops everything, lets the last request end, and closes the port. The program stays on the screen as last read,
   * with everything that was typed.
   */
  async disconnect(): Promise<void> {
    const { runner, link, notices, recovery } = this.#parts;
    void runner.stop();
    const closing = link.stop();
    batch(() => {
      notices.dismiss();
      recovery.anotherTimer();
    });
    await closing;
    await link.refresh();
  }

  /** The pilot has said how this timer works: reads it again in that way. */
  async assume(quirks: AssumedQuirks): Promise<void> {
    const { runner, link, reader } = this.#parts;
    if (runner.busy.value) return;
    await link.assume(quirks);
    await reader.read(true);
  }

  /** Forgets all assumptions about the connected kind of timer on its port, and reads it again without them. */
  async forgetAssumed(): Promise<void> {
    const { runner, link, reader } = this.#parts;
    const connection = link.connection.value;
    if (runner.busy.value || !connection) return;
    await link.forgetAssumed(connection);
    if (connection === link.connection.value) await reader.read(true);
  }

  /** The state of the link has changed: tells everything that depends on which timer is there. */
  #follow(state: LinkState, before: LinkState): void {
    const { runner, knowledge, recovery, nextFlight, notices, link, reader } = this.#parts;
    const isSilent = before.status === 'on' && ['waiting', 'searching'].includes(state.status);
    if (isSilent || state.status === 'away') reader.timerAway(true);
    if (state.status === 'on') {
      reader.timerCame(state.connection);
      return;
    }
    runner.connectionOver();
    knowledge.connectionOver();
    // The offer depends on the content of a timer that is no longer there.
    if (before.status === 'on') recovery.anotherTimer();
    if (state.status !== 'off') return;
    reader.timerAway(false);
    nextFlight.forget();
    if (!state.error) return;
    const { code, bytes } = state.error;
    const port = portInfoOf(before);
    notices.show({ kind: 'connection', code, port, bytes });
    void link.refresh();
  }

  /** Settles once the timer is read, or has to be waited for. */
  async #goTo(find: () => Promise<SerialPortLike | null>): Promise<void> {
    const { engaged, notices, link, reader } = this.#parts;
    if (engaged.value) return;
    notices.dismiss();
    await link.begin(find);
    await reader.settled();
  }
}
