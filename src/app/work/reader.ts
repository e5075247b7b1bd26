import { batch, type ReadonlySignal, signal } from '@preact/signals';
import { differences, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { replaceAll } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Draft } from '../storage/index.js';
import type { JobContext, JobRunner } from '../timer/job-runner.js';
import type { Knowledge } from '../timer/knowledge.js';
import type { Link } from '../timer/link.js';
import type { NextFlight } from '../timer/next-flight.js';
import type { Notices } from '../timer/notices.js';
import { kindKey, programKey } from '../timer/record-keys.js';
import type { Safety } from '../timer/safety.js';
import type { Standings } from '../timer/standing.js';
import type { UnfinishedRecords } from '../timer/unfinished.js';
import type { Drafts } from './drafts.js';
import type { InterruptedJobs } from './interrupted-jobs.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';

/** The models that a reading changes, or depends on. */
interface ReaderParts {
  readonly editor: Editor;
  readonly onScreen: OnScreen;
  readonly origin: Origin;
  readonly standings: Standings;
  readonly link: Link;
  readonly runner: JobRunner;
  readonly notices: Notices;
  readonly safety: Safety;
  readonly records: UnfinishedRecords;
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
   * @param comes whether it comes to the screen even when the pilot has opened another one: see `OnScreen.apart`.
   * @returns whether it was read.
   */
  async read(comes = false): Promise<boolean> {
    return await this.#parts.runner.run('read', async ({ client }, options) => {
      await this.#show(await client.readProgram(options), options, comes ? 'comes' : 'current');
    });
  }

  /** Within a job: shows a memory that was read on a round trip, and that does not fly next. */
  async showApart(read: TimerProgram, options: JobContext): Promise<void> {
    await this.#show(read, options, 'apart');
  }

  /**
   * Shows the memory that flies next in place of one that was opened apart from it: as last read, with the edits that
   * belong to it. Sends nothing.
   * @returns whether it is on the screen.
   */
  async showNext(): Promise<boolean> {
    const { editor, onScreen, runner, standings, notices, drafts, link } = this.#parts;
    if (!onScreen.apart.peek()) return true;
    const next = standings.next.peek();
    const simulated = link.simulated.peek();
    if (next?.known.state !== 'read') return false;
    const { program } = next.known;
    const draft = await drafts.of(program, simulated);
    // Meanwhile it may have been read, or the connection may have ended.
    const now = standings.next.peek()?.known;
    if (runner.busy.peek() || now?.state !== 'read' || now.program !== program) return false;
    const isKept = editor.dirty.peek();
    batch(() => {
      const moved = this.#bring(program, simulated, draft, false);
      if (moved) notices.say('moved');
      else if (draft && editor.dirty.value) notices.say('back');
      else if (isKept) notices.say('kept');
    });
    return true;
  }

  /**
   * Within a job that selects another memory: reads the current one if something was sent into it. Later nobody could
   * say whether it went there.
   */
  async readSent({ client }: Pick<TimerConnection, 'client'>, options: JobContext): Promise<void> {
    const { editor } = this.#parts;
    if (editor.baseline.peek() !== null && !editor.fresh.peek()) {
      await this.#show(await client.readProgram(options), options);
    }
  }

  /**
   * Selects another memory and reads it. Edits of the memory before are kept until it is read again. If this is stopped
   * or fails on the way, it reads the memory that is then current.
   */
  async selectMemory(memory: number): Promise<boolean> {
    const { runner, nextFlight, editor, onScreen, recovery, link } = this.#parts;
    const select = async ({ client, identity }: TimerConnection, options: JobContext): Promise<void> => {
      await this.readSent({ client }, options);
      const before = onScreen.apart.peek() ? nextFlight.memory.peek() : editor.baseline.peek()?.memory;
      nextFlight.leave(memory);
      // Cut on the way, this is said until a reading shows which of the two flies next.
      const original = before ?? memory;
      await recovery.leave({ job: 'select', memory }, identity, original, link.simulated.peek());
      options.stillOn();
      await client.selectMemory(memory, options);
      await this.#show(await client.readProgram(options), options, 'comes');
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

  /**
   * Shows a reading, with the edits that belong to it. One of the current memory leaves another one on the screen that
   * the pilot has opened there, also when the timer comes back; not when a new timer is connected.
   * @param which `comes`: the current memory, which comes to the screen in any case. `apart`: a memory that is not
   * current.
   */
  async #show(read: TimerProgram, { stillOn }: JobContext, which: 'current' | 'comes' | 'apart' = 'current') {
    const at = Date.now();
    const { editor, onScreen, link, records, knowledge, recovery, nextFlight, notices, drafts } = this.#parts;
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
    const isApart = which === 'apart';
    const stays = which === 'current' && onScreen.apart.value && !this.#isNew && !same && !otherKind;
    const setAside = before !== null && !same && editor.dirty.value;
    // Both at once, so that a storage that does not answer is waited for only once.
    const [draft] = await Promise.all([
      // The screen may still show the earlier reading.
      stays || (same && (editor.dirty.value || !this.#isNew)) ? undefined : drafts.of(read, simulated),
      records.loadAgain(),
    ]);
    this.#isNew = false;
    stillOn();
    const isBack = this.#wasAway;
    this.#wasAway = false;
    batch(() => {
      const shown = knowledge.read(read, at);
      recovery.wasRead(read, simulated, isApart ? nextFlight.memory.value : read.memory);
      if (!isApart) {
        nextFlight.found(read.memory);
        this.#byteOrderOpen.value = link.connection.value?.client.byteOrderOpen ?? false;
      }
      const moved = !stays && this.#bring(read, simulated, draft, isApart);
      if (laid) editor.apply({ ...replaceAll({ code: 'open', params: {} }, laid), owner });
      // What was tried explains the reading, and the offer to finish an interrupted write does; no other message does.
      const explained = shown === 'tried' || recovery.offer.value?.kind === 'write';
      if (shown === 'completed') notices.say('write-completed');
      else if (stays) return;
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

  /**
   * Brings a reading to the screen.
   * @returns whether the timer has changed under the edits: see `Editor.rebase`.
   */
  #bring(read: TimerProgram, simulated: boolean, draft: Draft | undefined, isApart: boolean): boolean {
    const { editor, onScreen, origin } = this.#parts;
    const before = editor.working.value;
    const same = before !== null && programKey(before, onScreen.simulated.value) === programKey(read, simulated);
    if (!same) onScreen.clear();
    if (draft) editor.restore(draft);
    const moved = editor.rebase(read);
    if (draft) origin.take(draft.model);
    onScreen.wasRead(simulated, isApart);
    return moved;
  }
}
