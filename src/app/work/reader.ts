import { batch, type ReadonlySignal, signal } from '@preact/signals';
import { differences, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { replaceAll } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { isOfOneShape } from '../editing/shape.js';
import type { JobContext, JobRunner } from '../timer/job-runner.js';
import type { Knowledge } from '../timer/knowledge.js';
import type { Link } from '../timer/link.js';
import type { NextFlight } from '../timer/next-flight.js';
import type { Notices } from '../timer/notices.js';
import { kindKey, programKey } from '../timer/record-keys.js';
import type { Safety } from '../timer/safety.js';
import type { Drafts } from './drafts.js';
import type { InterruptedJobs } from './interrupted-jobs.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';

/** The models that a reading changes, or depends on. */
interface ReaderParts {
  readonly editor: Editor;
  readonly onScreen: OnScreen;
  readonly origin: Origin;
  readonly link: Link;
  readonly runner: JobRunner;
  readonly notices: Notices;
  readonly safety: Safety;
  readonly knowledge: Knowledge;
  readonly recovery: InterruptedJobs;
  readonly nextFlight: NextFlight;
  readonly drafts: Drafts;
}

/** Reads the timer, and shows its content with the edits that belong to it. */
export class Reader {
  readonly #byteOrderOpen = signal(false, { name: 'byteOrderOpen' });
  /** Whether it is open how this timer writes its times. The pilot has to choose before times are written. */
  readonly byteOrderOpen: ReadonlySignal<boolean> = this.#byteOrderOpen;
  readonly #parts: ReaderParts;
  /** Whether the timer was away or silent, so that the next reading is of one that has come back. */
  #wasAway = false;
  /** Whether a new timer has come, for which there may be stored edits. */
  #isNew = false;
  #firstReading: Promise<unknown> = Promise.resolve();

  constructor(parts: ReaderParts) {
    this.#parts = parts;
  }

  /** @param isAwaited whether the timer is away or silent, and the next one may be the same. */
  timerAway(isAwaited: boolean): void {
    this.#wasAway = isAwaited;
  }

  /** A timer has given its identity: reads its content. */
  timerCame({ identity }: TimerConnection): void {
    const { safety, knowledge, recovery, nextFlight, link } = this.#parts;
    this.#isNew = !this.#wasAway;
    batch(() => {
      safety.withdraw();
      this.#byteOrderOpen.value = false;
      nextFlight.timerCame(identity, link.simulated.value);
      knowledge.anotherTimer();
      recovery.anotherTimer();
    });
    this.#firstReading = Promise.all([link.remember(), this.read()]);
  }

  /** Settles when the latest timer was read, successfully or not. */
  async settled(): Promise<void> {
    await this.#firstReading;
  }

  /**
   * Reads the current memory again. Edits stay.
   * @returns whether it was read.
   */
  async read(): Promise<boolean> {
    return await this.#parts.runner.run('read', async ({ client }, options) =>
      this.#show(await client.readProgram(options), options),
    );
  }

  /**
   * Selects another memory and reads it. Edits of the memory before are kept until it is read again. If this is stopped
   * or fails on the way, it reads the memory that is then current.
   *
   * What was sent into the memory before is read first: later nobody could say whether it went there.
   */
  async selectMemory(memory: number): Promise<boolean> {
    const { runner, nextFlight, editor, recovery, link } = this.#parts;
    const select = async ({ client, identity }: TimerConnection, options: JobContext): Promise<void> => {
      const isSent = editor.baseline.peek() !== null && !editor.fresh.peek();
      if (isSent) await this.#show(await client.readProgram(options), options);
      nextFlight.leave(memory);
      // Cut on the way, this is said until a reading shows which of the two flies next.
      const original = editor.baseline.peek()?.memory ?? memory;
      await recovery.leave({ job: 'select', memory }, identity, original, link.simulated.peek());
      options.stillOn();
      await client.selectMemory(memory, options);
      await this.#show(await client.readProgram(options), options);
    };
    const good = await runner.run('select', select, memory);
    if (good) this.#chose(memory);
    else await this.readIfOpen();
    return good;
  }

  #chose(memory: number): void {
    const { nextFlight, recovery, link } = this.#parts;
    const identity = link.connection.peek()?.identity;
    nextFlight.chose(memory);
    if (identity) void recovery.chose(identity, link.simulated.peek());
  }

  /** Reads if a job has left it open which memory is current. The message about that job stays. */
  async readIfOpen(): Promise<void> {
    const { notices, nextFlight, link } = this.#parts;
    if (nextFlight.open.value && link.connection.value) await notices.keepThrough(() => this.read());
  }

  /**
   * Takes in what a job has read of any memory. If it is the one on the screen, the screen shows it, with the edits on
   * top: it must not go on showing an older reading as the last one.
   */
  took(read: TimerProgram, verified = false): void {
    const { editor, onScreen, link, knowledge, notices } = this.#parts;
    const shown = editor.working.peek();
    const wasSimulated = onScreen.simulated.peek();
    // The connection may have ended since.
    const simulated = link.connection.peek() ? link.simulated.peek() : wasSimulated;
    batch(() => {
      knowledge.read(read, Date.now(), verified);
      if (!shown || programKey(shown, wasSimulated) !== programKey(read, simulated)) return;
      if (editor.rebase(read)) notices.sayIfSilent('moved');
    });
  }

  /** Shows a reading, with the edits that belong to it. */
  async #show(read: TimerProgram, { stillOn }: JobContext): Promise<void> {
    const at = Date.now();
    const { editor, onScreen, origin, link, knowledge, recovery, nextFlight, notices, drafts } = this.#parts;
    const simulated = link.simulated.value;
    const wasSimulated = onScreen.simulated.value;
    const before = editor.working.value;
    // A program that was made here is for any timer that can take it: its values go on top of what the timer holds.
    const made = editor.madeAt.value === null ? null : before;
    const owner = { of: editor.of.value, backupOf: editor.backupOf.value };
    const laid = made && isOfOneShape(made.identity, read.identity) && editor.unreadable.value.size === 0 ? made : null;
    const held = editor.baseline.value;
    const same = before !== null && programKey(before, wasSimulated) === programKey(read, simulated);
    const otherKind = before !== null && kindKey(before.identity, wasSimulated) !== kindKey(read.identity, simulated);
    const setAside = before !== null && !same && editor.dirty.value;
    // Both at once, so that a storage that does not answer is waited for only once.
    const [draft] = await Promise.all([
      // The screen may still show the earlier reading.
      same && (editor.dirty.value || !this.#isNew) ? undefined : drafts.of(read, simulated),
      knowledge.refresh(),
    ]);
    this.#isNew = false;
    stillOn();
    const isBack = this.#wasAway;
    this.#wasAway = false;
    batch(() => {
      const shown = knowledge.read(read, at);
      recovery.wasRead(read, simulated);
      // What was tried explains the reading, and the offer to finish an interrupted write does; no other message does.
      const explained = shown === 'tried' || recovery.offer.value?.kind === 'write';
      if (!same) onScreen.clear();
      if (draft) editor.restore(draft);
      const moved = editor.rebase(read);
      if (draft) origin.take(draft.model);
      if (laid) editor.apply({ ...replaceAll({ code: 'open', params: {} }, laid), owner });
      nextFlight.found(read.memory);
      this.#byteOrderOpen.value = link.connection.value?.client.byteOrderOpen ?? false;
      onScreen.wasRead(simulated);
      if (shown === 'completed') notices.say('write-completed');
      else if (made) notices.say(laid ? 'made-laid' : 'kept');
      else if (moved && !explained) notices.say('moved');
      else if (draft && editor.dirty.value && !explained) notices.say('back');
      else if (isBack && otherKind) notices.say('other-kind');
      else if (setAside) notices.say('kept');
      else if (isBack && same && held && !explained && differences(held, read).length > 0) {
        notices.say('timer-moved');
      }
    });
  }
}
