import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { fieldKey, type SharedSetting, sameLayout, type TimerProgram } from '../../program/index.js';
import { tried as attempted } from '../browser/services.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { changesSince } from '../editing/content.js';
import { eitherOf } from '../messages/either.js';
import { dateText, messages, valueText } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName, timerName } from '../messages/names.js';
import type { Session } from '../work/session.js';
import { qrLinkOf, sharedOf } from '../work/setting-link.js';
import { hintText, madeAs, programName, standingText } from '../work/standing-text.js';
import { isOfLibrary, memoryKey, ON_SCREEN, PAPER_KEYS, type Paper, type PrintOrder } from './print-order.js';
import { type Sheet, type SheetSource, sheetOf } from './sheet.js';

/** The parts of a sheet that the pilot can choose besides the table. */
export const SHEET_PARTS = ['timeline', 'notes', 'lines', 'code'] as const;
export type SheetPart = (typeof SHEET_PARTS)[number];

/** Without the code: most pilots would rather write in its place. */
const USUAL_PARTS: readonly SheetPart[] = ['timeline', 'notes', 'lines'];

type PrintParts = Pick<
  Session,
  'editor' | 'library' | 'opened' | 'origin' | 'servoUses' | 'simulated' | 'standing' | 'standings'
>;

/** What to print, and on which paper. */
export class Print {
  readonly #parts: PrintParts;
  readonly #page: string;

  readonly order: PrintOrder;
  // Only this model writes these.
  readonly paper = signal<Paper>(loadSetting('print/paper', v.picklist(PAPER_KEYS)) ?? 'a5');
  readonly parts = signal<ReadonlySet<SheetPart>>(
    new Set(loadSetting('print/parts', v.array(v.picklist(SHEET_PARTS))) ?? USUAL_PARTS),
  );
  readonly sheets: ReadonlySignal<readonly Sheet[]>;

  /** @param page the address of the page, for the codes. */
  constructor(parts: PrintParts, order: PrintOrder, page: string) {
    this.#parts = parts;
    this.#page = page;
    this.order = order;
    const { editor } = parts;
    this.sheets = computed(() =>
      order.keys.value.flatMap((key) => {
        const source = key === ON_SCREEN ? this.#onScreen() : isOfLibrary(key) ? this.#kept(key) : this.#memory(key);
        return source ? [sheetOf(source, editor.shortDt.value)] : [];
      }),
    );
  }

  setPaper(paper: Paper): void {
    this.paper.value = paper;
    saveSetting('print/paper', paper);
  }

  togglePart(part: SheetPart): void {
    const parts = new Set(this.parts.peek());
    if (!parts.delete(part)) parts.add(part);
    this.parts.value = parts;
    saveSetting('print/parts', [...parts]);
  }

  #kept(key: string): SheetSource | null {
    const { library } = this.#parts;
    const setting = library.settings.get(key)?.setting;
    if (!setting) return null;
    const { program, name, note, from, at } = setting;
    const model = library.models.get(setting.model)?.model ?? null;
    const { setting: words } = moreMessages.value.library;
    return {
      key,
      program,
      model,
      name,
      note,
      origin: words.origin({ source: words.from[from], time: dateText(at) }),
      simulated: from === 'simulated',
      link: this.#linkOf(sharedOf(setting, model)),
    };
  }

  #onScreen(): SheetSource | null {
    const { origin, servoUses } = this.#parts;
    const program = origin.program.value;
    if (!program) return null;
    const model = origin.model.value;
    // What the servos of the connected timer move says nothing about another model.
    const servos = (origin.crossing.value ? null : servoUses.named.value) ?? model?.servos ?? [];
    return {
      ...this.#ofTimer(ON_SCREEN, program, model && { ...model, servos }, programName(this.#parts)),
      note: origin.setting.value?.note ?? '',
      origin: this.#standing(),
      was: this.#was(program),
    };
  }

  #memory(key: string): SheetSource | null {
    const { standings, origin, servoUses } = this.#parts;
    const read = standings.readMemories().find(({ memory }) => memoryKey(memory) === key);
    if (!read) return null;
    const { known, memory, program } = read;
    const { knowledge: words } = messages.value;
    const model = origin.timer.value;
    const servos = servoUses.named.value ?? model?.servos ?? [];
    const isRead = known.state === 'read';
    return {
      ...this.#ofTimer(key, program, model && { ...model, servos }, ''),
      origin: isRead ? words.lastReadAt({ time: dateText(known.at) }) : words.unknown({ memory: memoryName(memory) }),
    };
  }

  #ofTimer(key: string, program: TimerProgram, model: SheetSource['model'], name: string): SheetSource {
    return {
      key,
      program,
      model,
      name,
      note: '',
      origin: '',
      simulated: this.#parts.simulated.value,
      link: this.#linkOf({
        name: name || timerName(program.identity),
        at: Date.now(),
        tags: [],
        program,
        modelName: model?.name ?? '',
      }),
    };
  }

  /** Without the note, which would make the code too fine. */
  #linkOf(shared: Omit<SharedSetting, 'note'>): string | null {
    if (!this.parts.value.has('code')) return null;
    return attempted(() => qrLinkOf({ ...shared, note: '' }, this.#page)?.link);
  }

  /** What is known about the screen's program and the timer. On paper nothing of it changes any more. */
  #standing(): string {
    const { editor, origin } = this.#parts;
    const standing = this.#parts.standing.value;
    const tried = standing.sure === 'once' ? (standing.sent ?? 0) : 0;
    const made = madeAs(this.#parts);
    const changes = made ? 0 : editor.changes.value.length;
    const unfinished = editor.unreadable.value.size;
    const memory = editor.working.value?.memory ?? null;
    const crossing = origin.crossing.value;
    const said = [
      crossing &&
        moreMessages.value.whichModel.crossing.title({
          from: crossing.from.name,
          to: eitherOf(crossing.to.map(({ name }) => name)),
        }),
      // A field without a value is printed with its last one.
      standingText(standing, { tried, changes, unfinished: 0 }, made, memory, dateText),
      // Read on paper, it is past: the timer may hold something else by then.
      changes + tried > 0 && hintText({ ...standing, sure: 'once' }, dateText),
      unfinished > 0 && moreMessages.value.print.unfinished({ count: unfinished }),
    ];
    return said
      .filter((text) => typeof text === 'string')
      .map((text) => text.replace(/\.$/, ''))
      .join('. ');
  }

  /** Marks values on the screen that are not in the timer, or not in the setting that is of no timer. */
  #was({ identity }: TimerProgram): Sheet['was'] {
    const { editor, origin, standings } = this.#parts;
    const { marks } = messages.value.knowledge;
    const isMade = editor.madeAt.value !== null;
    const working = editor.working.value;
    const saved = origin.setting.value?.program;
    const isSaved = saved && working && sameLayout(saved.identity, working.identity);
    const ofMade = isSaved ? changesSince(saved, working) : [];
    const mark = !isMade && standings.screen.value.sure === 'not' ? marks.once : marks.now;
    const texts = (isMade ? ofMade : standings.sinceRead.value).map(({ field, from }) => {
      return [fieldKey(field), mark({ value: valueText(identity, field, from) })] as const;
    });
    const was = new Map(texts);
    return (field) => was.get(fieldKey(field)) ?? '';
  }
}
