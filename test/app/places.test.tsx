import { cleanup, render } from '@testing-library/preact';
import { afterEach, describe, expect, it } from 'vitest';
import { ComparedPair, SCREEN } from '../../src/app/compare/choice.js';
import { Compare } from '../../src/app/compare/compare.js';
import { sideName } from '../../src/app/compare/compare-page.js';
import { SaveButtons } from '../../src/app/library/save-buttons.js';
import { SaveDialog } from '../../src/app/library/save-dialog.js';
import { offerScreen } from '../../src/app/library/share/share-screen.js';
import { messages } from '../../src/app/messages/index.js';
import { programOf } from '../../src/app/messages/names.js';
import { Print } from '../../src/app/print/print.js';
import { memoryKey, ON_SCREEN, PrintOrder } from '../../src/app/print/print-order.js';
import { KnownLine } from '../../src/app/shell/known-line.js';
import { SettingLine } from '../../src/app/shell/setting-line.js';
import { StripModel } from '../../src/app/shell/strip-model.js';
import type { ModelRecord } from '../../src/app/storage/index.js';
import { BackupList } from '../../src/app/write/backup-list.js';
import { decodeLink, fieldsOf } from '../../src/program/index.js';
import { en } from '../tools/en.js';
import { type AppBench, goOn, review, run } from './bench/bench.js';
import { BACKUP, CALM, DT, LANCER_HELD, lancerBench, type, WIND } from './two-models.js';

/** Whose timer is connected: of the Lancer, of a model that the page does not know, or none. */
const TIMERS = ['Lancer', 'unknown', 'none'] as const;
/** Where the values on the screen come from. */
const ORIGINS = ['timer', 'setting', 'setting of another', 'backup of another', 'backup of nobody'] as const;
/**
 * How certain the content of the timer is. `sent`: something was sent since it was read, as by the servos that follow.
 */
const STANDINGS = ['read', 'verified', 'sent', 'interrupted', 'disconnected'] as const;

interface Case {
  readonly timer: (typeof TIMERS)[number];
  readonly origin: (typeof ORIGINS)[number];
  readonly changed: boolean;
  readonly standing: (typeof STANDINGS)[number];
  /** Whether M3 was opened in the table, while M1 flies next. */
  readonly apart: boolean;
}

const CASES: readonly Case[] = TIMERS.flatMap((timer) =>
  ORIGINS.flatMap((origin) =>
    [false, true].flatMap((changed) =>
      STANDINGS.flatMap((standing) =>
        [false, true].map((apart): Case => ({ timer, origin, changed, standing, apart })),
      ),
    ),
  ),
)
  // Without a timer there are no values of one, and nothing is read.
  .filter(
    ({ timer, origin, standing, apart }) =>
      timer !== 'none' || (origin !== 'timer' && standing === 'disconnected' && !apart),
  );

const { model: _, ...NOBODYS } = BACKUP;

afterEach(cleanup);

/** Brings the page into the state of a case. */
async function reach({ timer, origin, changed, standing, apart }: Case): Promise<AppBench> {
  const bench = await lancerBench();
  const { session } = bench;
  if (timer === 'unknown') {
    const positions = LANCER_HELD.positions.map((row) => row.map((position, slot) => (position + 11 * slot) % 100));
    bench.timer.core.memories[0] = { times: LANCER_HELD.times.map((time) => time + 300), positions };
  }
  // So that M3 says the same of the model as M1 does.
  bench.timer.core.memories[2] = structuredClone(bench.timer.core.content);
  if (timer !== 'none') await run(session.timer.connect());
  if (apart) await run(bench.memories.edit(2));
  if (origin === 'setting') await run(session.opened.show(CALM));
  if (origin === 'setting of another') await run(session.opened.show(WIND));
  if (origin === 'backup of another') session.onScreen.showBackup(BACKUP);
  if (origin === 'backup of nobody') session.onScreen.showBackup(NOBODYS);
  if (changed) type(bench, DT, '2:00');
  if (standing === 'verified') await write(bench);
  if (standing === 'sent') bench.editor.sent();
  if (standing === 'interrupted') {
    bench.timer.core.onAnswer = ({ name }) => {
      if (name.startsWith('SET') && name !== 'SETMEMORY') bench.timer.core.sleep();
    };
    const kept = bench.editor.working.value;
    // Something has to be sent for it to be interrupted.
    if (bench.editor.changes.value.length === 0) type(bench, DT, '4:00');
    await write(bench);
    if (kept && bench.editor.working.value?.times[10] === 24_000 && !changed) bench.editor.undo();
  }
  if (standing === 'disconnected' && timer !== 'none') await run(session.timer.disconnect());
  return bench;
}

async function write(bench: AppBench): Promise<void> {
  await review(bench);
  bench.session.safety.confirm();
  bench.write.tick('model', true);
  bench.write.tick('warnings', true);
  await goOn(bench);
  bench.write.dismiss();
}

/** The text of a part of the page. */
function drawn(part: Parameters<typeof render>[0]): string {
  const { container, unmount } = render(part);
  const text = (container.textContent ?? '').replaceAll('\u00a0', ' ').replaceAll(/\s+/g, ' ').trim();
  unmount();
  return text;
}

/** Everything that names a model, or says what a timer holds, in one list. */
function placesOf(bench: AppBench, memoryOfTimer: number) {
  const { session, saveSetting, sharing, flights, follow } = bench;
  const order = new PrintOrder();
  order.choose([ON_SCREEN, memoryKey(memoryOfTimer)]);
  const print = new Print(session, order, 'https://example.org/');
  if (!print.parts.value.has('code')) print.togglePart('code');
  const [screen, memory] = print.sheets.value;
  const linked = (link: string | null | undefined) => (link ? decodeLink(link) : null);
  offerScreen(session, sharing);
  const offered = sharing.current.value?.step === 'offer' ? sharing.current.value.shared : null;
  const pair = new ComparedPair();
  pair.show(SCREEN, null);
  const compare = new Compare(session, pair);
  const sideOf = (kind: 'screen' | 'timer'): string => {
    const side = compare.sides.value.find(
      (each) => each.kind === kind && (each.kind !== 'timer' || each.held.memory === memoryOfTimer),
    );
    return side ? sideName(session, side).replaceAll('\u00a0', ' ') : '';
  };
  saveSetting.open();
  render(<SaveDialog session={session} saveSetting={saveSetting} />);
  const suggested = document.querySelector<HTMLSelectElement>('dialog select')?.selectedOptions[0]?.textContent ?? '';
  cleanup();
  saveSetting.dismiss();
  const backupsOf = (key: string): string => {
    const record = session.library.models.get(key) as ModelRecord;
    return drawn(<BackupList session={session} of={record} following={false} onLoad={() => {}} onCompare={() => {}} />);
  };
  const key = flights.flying() ?? '';
  const flown = session.library.flights.get(key)?.flight ?? null;
  flights.remove(key);
  return {
    strip: drawn(<StripModel session={session} />),
    known: drawn(<KnownLine session={session} follow={follow} />),
    setting: drawn(<SettingLine session={session} />),
    save: drawn(<SaveButtons session={session} saveSetting={saveSetting} />),
    suggested,
    sheet: screen,
    memorySheet: memory,
    code: linked(screen?.link),
    memoryCode: linked(memory?.link),
    link: offered,
    screenSide: sideOf('screen'),
    timerSide: sideOf('timer'),
    lancerBackups: backupsOf('Lancer'),
    magpieBackups: backupsOf('Magpie'),
    flown,
  };
}

/** The beginnings of the sentences that say something of a timer. */
const SAYS = {
  now: en.knowledge.readAt({ time: '' }).trim(),
  verified: en.knowledge.verified({ time: '' }).trim(),
  once: en.knowledge.lastRead,
  not: en.knowledge.unknown({ memory: 'M' }).replace(/M .*/, 'M'),
};

/** Which of them stand in a text. “As in the timer, read” is no part of “verified”. */
function saidIn(text: string): string[] {
  return Object.entries(SAYS).flatMap(([name, sentence]) => (text.includes(sentence) ? [name] : []));
}

describe('every place that names a model or says what a timer holds', () => {
  it.each(CASES)('$timer timer, values of $origin, changed: $changed, $standing, M3: $apart', async (which) => {
    const { timer, origin, standing, apart } = which;
    const bench = await reach(which);
    const { editor, session } = bench;
    // The timer that fell asleep during a write is waited for.
    const isConnected = timer !== 'none' && standing !== 'disconnected' && standing !== 'interrupted';
    const held = timer === 'none' ? null : timer;
    const changes = editor.changes.value.length;
    const isMade = timer === 'none';

    // Whose the values are, by where they come from alone.
    const own = held === 'Lancer' ? 'Lancer' : '';
    const model = {
      timer: own,
      setting: 'Lancer',
      'setting of another': 'Magpie',
      'backup of another': 'Magpie',
      'backup of nobody': '',
    }[origin];
    const setting = { setting: 'calm', 'setting of another': 'wind' }[origin as string] ?? '';
    const saved = { setting: CALM, 'setting of another': WIND }[origin as string];
    const isSaved =
      saved !== undefined && JSON.stringify(saved.program.times) === JSON.stringify(editor.working.value?.times);
    const title = setting === '' || isSaved ? setting : en.knowledge.changed({ name: setting });

    // What may be said of the timer, by what has happened to it alone.
    const sentence = ((): string[] => {
      if (isMade) return [];
      if (standing === 'interrupted') return ['not'];
      if (changes > 0) return [];
      return standing === 'read' ? ['now'] : standing === 'verified' ? ['verified'] : ['once'];
    })();

    const places = placesOf(bench, apart ? 2 : 0);
    const other = model === 'Magpie' ? 'Lancer' : 'Magpie';

    // The connected timer has its own name, whatever lies over it.
    expect(places.strip).toBe(isConnected ? own || messages.value.recognition.which : '');
    expect(saidIn(places.known)).toEqual(sentence);
    const state = en.library.save.state({ name: setting, changes: isSaved ? 0 : 1 }).slice(setting.length);
    if (isConnected && setting !== '') {
      expect(places.setting.startsWith(en.knowledge.ofModel({ name: setting, model }))).toBe(true);
      expect(places.setting.endsWith(isSaved ? state : 'not saved')).toBe(true);
    } else expect(places.setting).toBe('');

    // Saving names what it overwrites, and goes to the model of the values.
    const over = en.library.save.over({ program: programOf(setting, model) }).replaceAll('\u00a0', ' ');
    if (setting !== '' && !isSaved) expect(places.save).toContain(over);
    else expect(places.save).not.toContain('over');
    if (model !== '') expect(places.suggested).toBe(model);

    // Paper, its code, and the link.
    const { sheet, memorySheet } = places;
    expect([sheet?.model, sheet?.name]).toEqual([model, title]);
    expect(sheet?.memory.includes(other), 'a memory has no name of another model').toBe(false);
    expect(saidIn(sheet?.origin ?? '')).toEqual(sentence);
    const isCrossing = isConnected && held === 'Lancer' && model === 'Magpie';
    const crossing = en.whichModel.crossing.title({ from: 'Magpie', to: 'Lancer' }).replace(/\.$/, '');
    expect(sheet?.origin.includes(crossing)).toBe(isCrossing);
    const marks = sheet ? fieldsOf(sheet.program.identity).filter(sheet.was).length : 0;
    if (changes > 0) expect(marks, 'each changed value is marked').toBe(editor.changes.value.length);
    if (changes === 0 && !isMade) expect(marks).toBe(0);
    if (sentence.includes('now') || sentence.includes('verified')) expect(marks).toBe(0);
    for (const shared of [places.code, places.link]) {
      expect([shared?.modelName, shared?.name.startsWith(title)]).toEqual([model, true]);
      expect(shared?.program.memory).toBe(sheet?.program.memory);
    }
    if (model === 'Magpie') expect(places.link?.program.memory).toBe(setting === 'wind' ? 1 : null);

    // A memory of the timer is of the model of the timer, and on paper it is never now.
    if (held === null) expect(memorySheet).toBeUndefined();
    else {
      expect([memorySheet?.model, memorySheet?.name, places.memoryCode?.modelName]).toEqual([own, '', own]);
      expect(saidIn(memorySheet?.origin ?? '')).toEqual([standing === 'interrupted' ? 'not' : 'once']);
    }

    // Side by side.
    const { compare } = en;
    expect(places.screenSide).toBe(
      title === '' ? compare.screen : compare.setting({ model: compare.screen, name: title }),
    );
    expect([places.timerSide !== '', saidIn(places.timerSide)]).toEqual([
      isConnected,
      standing === 'sent' ? ['once'] : [],
    ]);
    for (const [name, text] of [
      ['Lancer', places.lancerBackups],
      ['Magpie', places.magpieBackups],
    ] as const) {
      const isNow = name === own && (standing === 'read' || standing === 'verified');
      const { modelBackups } = en;
      if (!isNow) expect(text).not.toContain(modelBackups.same({ when: modelBackups.now }));
    }

    // A flight is of the memory that flies next, and of a setting only where the timer holds all of it. What was sent
    // or written into another one makes no difference.
    const isFlown = apart ? isConnected : standing === 'read' || standing === 'verified';
    expect(places.flown?.program.memory ?? null).toBe(isFlown ? 0 : null);
    if (!isFlown) expect(places.flown).toBeNull();
    else {
      const inTimer = session.standings.of(0).known;
      const isWhole = (of: typeof CALM): boolean =>
        inTimer.state === 'read' &&
        JSON.stringify([inTimer.program.times, inTimer.program.positions]) ===
          JSON.stringify([of.program.times, of.program.positions]);
      const flown = places.flown;
      const tied = flown?.setting === 'calm' ? CALM : flown?.setting === 'wind' ? WIND : null;
      if (tied) expect([isWhole(tied), flown?.settingName, flown?.model]).toEqual([true, tied.name, tied.model]);
      else if (flown?.settingName) expect(standing, 'it was written from a setting').toBe('verified');
      if (held === 'Lancer') expect(flown?.modelName).toBe('Lancer');
    }

    // What is saved now says when it was read, or that it was typed.
    const source = session.opened.source();
    const isRead = !isMade && changes === 0;
    if (setting !== '' && isSaved) expect(source).toEqual({ from: saved?.from, at: saved?.at });
    else if (isRead) expect(source).toEqual({ from: 'timer', at: session.standing.value.at });
    else expect(source.from).toBe('typed');
  });
});
