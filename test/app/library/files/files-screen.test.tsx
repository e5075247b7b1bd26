import { act, cleanup, fireEvent, screen, within } from '@testing-library/preact';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { holdDroppedFiles } from '../../../../src/app/browser/dropped-files.js';
import { faultText } from '../../../../src/app/library/files/place-in-file.js';
import { filesOf } from '../../../../src/app/library-files.js';
import { messages } from '../../../../src/app/messages/index.js';
import { countedText } from '../../../../src/app/messages/names.js';
import {
  formatLibraryFile,
  type Library as Kept,
  parseLibraryFile,
  type Setting,
} from '../../../../src/program/index.js';
import { FLIGHT, MODEL, SETTING } from '../../../program/library-examples.js';
import { en } from '../../../tools/en.js';
import { type AppBench, idle, MemoryStore } from '../../bench/bench.js';
import { button, connected, goTo, opened, press } from '../../screen.js';

beforeEach(holdDroppedFiles);

const ALL: Kept = { models: [MODEL], settings: [SETTING], flights: [FLIGHT] };
const DAY = 86_400_000;
const words = en.files.import;
const ONE_OF_EACH = { models: 1, settings: 1, flights: 1 };

const text = (library: Kept = ALL, writtenAt = 1): string =>
  formatLibraryFile(library, { writtenAt, writtenBy: 'Sidus Timer 1.0.0' });
const file = (content: BlobPart = text(), name = 'lancer.sidus.json'): File => new File([content], name);

/** The page in the library, with what it holds. */
async function library(holds: Partial<Kept> = ALL, store = new MemoryStore()): Promise<AppBench> {
  const app = await opened({ store });
  for (const model of holds.models ?? []) await app.session.library.keepModel(model);
  for (const setting of holds.settings ?? []) await app.session.library.keepSetting(setting);
  for (const flight of holds.flights ?? []) await app.session.library.keepFlight(flight);
  await goTo('library');
  await idle();
  return app;
}

/** Drops a file on the page. @returns whether the page has taken it from the browser. */
async function drop(...files: File[]): Promise<boolean> {
  const event = new Event('drop', { bubbles: true, cancelable: true });
  Object.assign(event, { dataTransfer: { types: ['Files'], files } });
  act(() => void document.body.dispatchEvent(event));
  await idle();
  return event.defaultPrevented;
}

const dialog = () => within(screen.getByRole('dialog'));
/** Chooses what to do with what differs. */
async function choose(way: keyof typeof words.ways): Promise<void> {
  act(() => void fireEvent.click(dialog().getByRole('radio', { name: words.ways[way] })));
  await idle(0);
}
const notice = (words: RegExp | string) => screen.getByText(words).closest('.notice') as HTMLElement;
const kept = ({ store }: AppBench) => ({
  models: [...store.models.records.values()].map(({ model }) => model),
  settings: [...store.settings.records.values()].map(({ setting }) => setting),
  flights: [...store.flights.records.values()].map(({ flight }) => flight),
});

/** What the browser was given to be saved. */
function downloads(): { name: string; text: () => Promise<string> }[] {
  const made: Blob[] = [];
  const found: { name: string; text: () => Promise<string> }[] = [];
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${made.push(blob as Blob) - 1}`);
  vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
    const blob = made[Number(this.href.replace('blob:', ''))] as Blob;
    found.push({ name: this.download, text: () => blob.text() });
  });
  return found;
}

describe('an import', () => {
  it('says what it will do, does it, and can be undone', async () => {
    const app = await library({});
    expect(await drop(file())).toBe(true);
    expect(dialog().getByRole('heading', { name: 'Import lancer.sidus.json' })).toBeTruthy();
    dialog().getByText(/^Saved .*\. It holds 1\smodel, 1\sprogram, 1\sflight\.$/);
    dialog().getByText(words.group.fresh({ what: '1 model, 1 program, 1 flight' }));
    expect(kept(app)).toEqual({ models: [], settings: [], flights: [] });
    await press('Import 3');
    expect(kept(app)).toEqual(ALL);
    expect(screen.queryByRole('dialog')).toBeNull();
    expect(notice(/^Imported from “lancer/).textContent).toContain(countedText(ONE_OF_EACH));
    await press(en.files.import.undo);
    expect(kept(app)).toEqual({ models: [], settings: [], flights: [] });
    notice(words.undone);
    expect(screen.queryByRole('button', { name: words.undo })).toBeNull();
  });

  it('is described in sentences whose order its name cannot change', async () => {
    await library({});
    await drop(file(text(), 'lancer\u202enosj.sidus'));
    expect(dialog().getByRole('heading', { name: 'Import lancernosj.sidus' })).toBeTruthy();
    await press('Import 3');
    notice(/^Imported from “lancernosj\.sidus”: /);
  });

  it('of entries that are there already has nothing to do', async () => {
    await library();
    await drop(file());
    dialog().getByText(en.files.import.nothing);
    expect(dialog().queryByRole('button', { name: /^Import/ })).toBeNull();
    await press('Close');
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  const windy: Setting = { ...SETTING, name: 'windy', at: Date.now() + DAY };
  it.each([
    ['newer', ['windy']],
    ['both', ['calm morning', 'windy (2)']],
  ] as const)('with “%s” brings %j', async (way, names) => {
    const app = await library();
    await drop(file(text({ ...ALL, settings: [windy] })));
    dialog().getByText(words.group.fileNewer({ what: 'windy (here: calm morning)' }));
    dialog().getByText(words.group.same({ what: '1 model, 1 flight' }));
    await choose(way);
    dialog().getByText(words.wayText[way]);
    await press(words.take({ count: 1 }));
    expect(
      kept(app)
        .settings.map(({ name }) => name)
        .sort(),
    ).toEqual(names);
    expect(kept(app).models).toEqual([MODEL]);
  });

  it.each([0, 1])('of a setting that is not newer brings nothing, and says so (%i)', async (isSameDate) => {
    const app = await library();
    const at = isSameDate ? (app.session.library.settings.list.value[0]?.changedAt ?? 0) : 1;
    await drop(file(text({ ...ALL, settings: [{ ...windy, at }] })));
    dialog().getByText(words.group.deviceNewer({ what: 'windy (here: calm morning)' }));
    expect(button(words.take({ count: 0 })).disabled).toBe(true);
    dialog().getByText(words.allStays);
    await choose('both');
    await press(words.take({ count: 1 }));
    expect(
      kept(app)
        .settings.map(({ name }) => name)
        .sort(),
    ).toEqual(['calm morning', 'windy (2)']);
  });

  it('asks once, also when several models differ', async () => {
    const other = { ...MODEL, id: 'b', name: 'Vega' };
    const app = await library({ ...ALL, models: [MODEL, other] });
    const vega: Kept['models'][number] = { ...other, note: 'new' };
    await drop(file(text({ ...ALL, models: [MODEL, vega], settings: [windy] }, Date.now() + DAY)));
    dialog().getByText(words.differs);
    await press(words.take({ count: 2 }));
    expect(kept(app).models.map(({ note }) => note)).toEqual([MODEL.note, 'new']);
    expect(kept(app).settings).toEqual([windy]);
  });

  it('asks nothing where nothing differs', async () => {
    await library({});
    await drop(file());
    expect(dialog().queryByRole('radio')).toBeNull();
  });

  it('names three of the entries that differ, and counts the others', async () => {
    const at = Date.now() + DAY;
    const settings = ['a', 'b', 'c'].map((id) => ({ ...SETTING, id, name: id }));
    const newer: Kept = {
      models: [{ ...MODEL, note: 'new' }],
      settings: settings.map((each) => ({ ...each, note: 'new', at })),
      flights: [{ ...FLIGHT, note: 'new', at }],
    };
    await library({ ...ALL, settings });
    await drop(file(text(newer, at)));
    dialog().getByText(words.group.fileNewer({ what: 'the model itself, a, b. And 2 more.' }));
    await press('Cancel');
    await drop(file(text({ ...newer, models: [MODEL], settings: [] }, at)));
    dialog().getByText(/^Newer in the file: flight of \S/);
  });

  it('names the models that have no name here', async () => {
    await library({});
    const settings = ['gone', null].map((model, at) => ({ ...SETTING, id: `s${at}`, model }));
    await drop(file(text({ models: [], settings, flights: [] })));
    dialog().getByText(words.unknownModel);
    dialog().getByText(messages.value.noModel);
  });

  it('of nothing says so once', async () => {
    await library({});
    await drop(file(text({ models: [], settings: [], flights: [] })));
    dialog().getByText(/It holds nothing\.$/);
    expect(dialog().queryByText(en.files.import.nothing)).toBeNull();
    button('Close');
  });

  it('says that it leaves out what this version does not know', async () => {
    await library({});
    await drop(file(text().replace('"name": "Lancer 07"', '"name": "Lancer 07", "colour": "red"')));
    dialog().getByText(words.ignored({ count: 1 }));
  });

  it('begins anew with each file, and Escape leaves it', async () => {
    await library();
    const newer = file(text({ ...ALL, settings: [windy] }));
    await drop(newer);
    await choose('both');
    act(() => void fireEvent(screen.getByRole('dialog'), new Event('cancel', { cancelable: true })));
    await idle();
    expect(screen.queryByRole('dialog')).toBeNull();
    await drop(newer);
    expect(dialog().getByRole<HTMLInputElement>('radio', { name: words.ways.newer }).checked).toBe(true);
  });

  it('shows the library with what has come', async () => {
    const app = await library({});
    await goTo('settings');
    expect(await drop(file()), 'the browser must not leave the page for it').toBe(true);
    expect(screen.queryByRole('dialog'), 'only the library takes it').toBeNull();
    act(() => void filesOf(app.models).import([file()]));
    await idle();
    await press('Import 3');
    expect(app.views.shown.value).toBe('library');
  });

  it('compares with the library at the click on Import, not at the opening of the file', async () => {
    const app = await library({});
    await drop(file());
    await app.session.library.keepModel(MODEL);
    await idle(0);
    await press('Import 2');
    expect(kept(app)).toEqual(ALL);
  });

  it('can be undone, and later changes stay', async () => {
    const app = await library({});
    await drop(file());
    await press('Import 3');
    await app.session.library.keepSetting({ ...SETTING, note: 'flew well' });
    await idle();
    await press(en.files.import.undo);
    expect(kept(app)).toEqual({ models: [], settings: [{ ...SETTING, note: 'flew well' }], flights: [] });
    notice(words.undone);
  });

  it('brings back each entry that it has replaced, and its message goes at a click', async () => {
    const app = await library();
    const at = Date.now() + DAY;
    const newer: Kept = {
      models: [{ ...MODEL, note: 'new' }],
      settings: [windy],
      flights: [{ ...FLIGHT, note: 'new', at }],
    };
    await drop(file(text(newer, at)));
    await press('Import 3');
    expect(kept(app)).toEqual(newer);
    await press(en.files.import.undo);
    expect(kept(app)).toEqual(ALL);
    await press('Dismiss');
    expect(screen.queryByText(/^The import was undone/)).toBeNull();
  });

  it('says when the browser does not keep it, and offers the way out', async () => {
    const app = await library({});
    await drop(file());
    app.store.broken = true;
    await press('Import 3');
    expect(notice(/^Imported from/).textContent).toContain(messages.value.notKept);
    const saved = downloads();
    await press(en.keeping.export);
    expect(saved).toHaveLength(1);
    expect(parseLibraryFile(await (saved[0]?.text() ?? '')).library).toEqual(ALL);
  });

  it('that is undone says when the browser does not keep that', async () => {
    const app = await library({});
    await drop(file());
    await press('Import 3');
    app.store.broken = true;
    await press(en.files.import.undo);
    notice(messages.value.notKept);
    expect(screen.queryByText(words.undone)).toBeNull();
    expect(app.session.library.models.list.value).toEqual([]);
  });

  it('that is undone says so only when the storage has done it', async () => {
    const app = await library({});
    await drop(file());
    await press('Import 3');
    const change = app.store.change.bind(app.store);
    let go = (): void => {};
    app.store.change = async (given) => {
      await new Promise<void>((resolve) => (go = resolve));
      await change(given);
    };
    fireEvent.click(button(en.files.import.undo));
    await idle(0);
    notice(messages.value.parts.coming);
    expect([screen.queryByText(words.undone), kept(app)]).toEqual([null, ALL]);
    go();
    await idle(0);
    notice(words.undone);
    expect(kept(app)).toEqual({ models: [], settings: [], flights: [] });
  });

  it('that is undone leaves the undo of a deletion where it is', async () => {
    const app = await library();
    await drop(file(text({ ...ALL, models: [{ ...MODEL, id: 'other' }] })));
    await press('Import 1');
    const { settings } = app.session.library;
    settings.remove(SETTING.id);
    fireEvent.click(button(en.files.import.undo));
    await idle(0);
    settings.undoRemove();
    expect(settings.list.value.map(({ key }) => key)).toEqual([SETTING.id]);
    await idle(20_000);
    expect(kept(app)).toEqual(ALL);
  });

  it('that ends after another one, and after an export, undoes itself and nothing else', async () => {
    const app = await library({});
    const { store } = app;
    const change = store.change.bind(store);
    const held: (() => void)[] = [];
    store.change = async (given) => {
      await new Promise<void>((resolve) => held.push(resolve));
      return change(given);
    };
    const part = (name: string) => ({
      models: [],
      settings: [{ ...SETTING, id: name, name, model: null }],
      flights: [],
    });
    /** Waits for no storage. */
    const click = async (name: string): Promise<void> => {
      fireEvent.click(button(name));
      await idle(0);
    };
    const imports = async (name: string): Promise<void> => {
      act(() => void filesOf(app.models).import([file(text(part(name)), name)]));
      await idle(0);
      await click('Import 1');
    };
    downloads();
    await imports('first');
    await imports('second');
    await click('Export all…');
    held[0]?.();
    await idle(0);
    notice(/^Imported from “first/);
    await click(en.files.import.undo);
    held[1]?.();
    await idle(0);
    notice(/^Imported from “second/);
    expect(app.session.library.settings.list.value.map(({ key }) => key)).toEqual(['second']);
    await click(en.files.import.undo);
    expect(app.session.library.settings.list.value).toEqual([]);
  });

  it.each([() => new Promise<never>(() => {}), () => Promise.reject(new Error('not now'))])(
    'does not overwrite a library that the browser does not give (%#)',
    async (all) => {
      const store = new MemoryStore();
      store.models.all = all;
      await opened({ store });
      await goTo('library');
      await idle();
      await drop(file());
      expect(button('Import 3').disabled).toBe(true);
      dialog().getByText(en.library.unread);
    },
  );
});

describe('what cannot be imported', () => {
  const { refused } = en.files;
  const calm = { kind: 'settings', number: 1, name: 'calm morning' } as const;
  const lancer = { kind: 'models', number: 1, name: '', slot: '', field: 'name' } as const;
  it.each([
    ['{ "format": "sidus-timer library", "version": 2 }', refused.newer, false],
    ['{ "format": "else" }', refused.format, false],
    [text().slice(0, -30), refused.damaged, true],
    [text().replace('"memory"', 'memory'), refused.damaged, true],
    [
      text().replace('"0.30"', '"700.00"'),
      faultText({ line: 35, found: '700' }, { ...calm, slot: '1', field: 'time' }),
      true,
      '0.00 to 655.35',
    ],
    [
      text().replace('"positions": [115, 115]', '"positions": [115, 1150]'),
      faultText({ line: 38, found: '1150' }, { ...calm, slot: 'DT', field: 'positions[1]' }),
      true,
      '0 to 255',
    ],
    [
      text().replace('"name": "Lancer 07"', '"name": ""'),
      faultText({ line: 9, found: '0' }, lancer),
      true,
      '1 to 60 characters',
    ],
    [text().replace('"name": "Lancer 07",', ''), faultText({ line: 7, found: '–' }, lancer), true, 'a text'],
    [`ÿþ{`, refused.damaged, true],
    [Uint8Array.of(0x7b, 0xff, 0x00), refused.damaged, true],
  ])('is refused with place and reason, %#', async (content, reason, isDamaged, wanted?: string) => {
    const app = await library();
    const before = kept(app);
    await drop(file(content as BlobPart));
    dialog().getByRole('heading', { name: refused.title({ name: 'lancer.sidus.json' }) });
    expect(
      dialog()
        .getByRole('alert')
        .textContent?.replaceAll(/[\u2068\u2069]/g, ''),
    ).toBe(reason.replaceAll(/[\u2068\u2069]/g, ''));
    expect(document.querySelector('q')?.textContent, 'in the English of the check').toBe(wanted);
    dialog().getByText(isDamaged ? `${refused.nothing} ${refused.again}` : refused.nothing);
    await press('Close');
    expect(kept(app)).toEqual(before);
  });

  it('is not even read when it is too large', async () => {
    await library();
    const huge = file();
    Object.defineProperty(huge, 'size', { value: 60_000_001 });
    const read = vi.spyOn(huge, 'arrayBuffer');
    await drop(huge);
    dialog().getByText(refused.files['too-large']);
    expect(read).not.toHaveBeenCalled();
  });

  it('includes several files at once, and one that is gone or hangs', async () => {
    await library();
    await drop(file(), file());
    dialog().getByText(refused.files.several);
    await press('Close');
    const gone = file();
    gone.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotFoundError'));
    await drop(gone);
    dialog().getByText(refused.files.gone);
    await press('Close');
    const silent = file();
    silent.arrayBuffer = () => new Promise(() => {});
    await drop(silent);
    dialog().getByText(messages.value.parts.coming);
    await press('Cancel');
    expect(screen.queryByRole('dialog')).toBeNull();
    await idle(100_000);
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it.each(['utf-16le', 'utf-16be'])('is not one in %s', async (encoding) => {
    const app = await library({});
    const letters = `\ufeff${text()}`;
    const bytes = new Uint8Array(2 * letters.length);
    const view = new DataView(bytes.buffer);
    for (const [at, letter] of [...letters].entries()) {
      view.setUint16(2 * at, letter.charCodeAt(0), encoding === 'utf-16le');
    }
    await drop(file(bytes));
    await press('Import 3');
    expect(kept(app)).toEqual(ALL);
  });

  it('includes a file dropped on an open dialog: the page does not open it, and stays', async () => {
    await connected();
    await press('Write…');
    expect(await drop(file())).toBe(true);
    expect(screen.queryByRole('heading', { name: /^Import/ })).toBeNull();
  });
});

describe('an export', () => {
  /** A name whose date does not break. */
  const shown = (file: { name: string } | undefined): string => (file?.name ?? '').replaceAll('-', '-\u2060');

  it('goes into the downloads, all of it', async () => {
    await library();
    const saved = downloads();
    await press('Export all…');
    expect(saved[0]?.name).toMatch(/^Sidus library \d{4}-\d\d-\d\d\.sidus\.json$/);
    const { library: read } = parseLibraryFile(await (saved[0]?.text() ?? ''));
    expect(read).toEqual(ALL);
    const said = en.files.export.downloaded({ name: shown(saved[0]), what: countedText(ONE_OF_EACH) });
    expect(document.querySelector('.notices')?.textContent).toContain(said);
  });

  it('is of one model, or of one setting, under its name', async () => {
    const slash = { ...MODEL, name: 'F1Q / "Lancer" ...' };
    const app = await library({ ...ALL, models: [slash] });
    const saved = downloads();
    app.models.views.show('library', `${MODEL.id}/${SETTING.id}`);
    await idle();
    fireEvent.click(within(screen.getByRole('article')).getByRole('button', { name: 'Export…' }));
    await idle();
    expect(saved[0]?.name).toMatch(/^F1Q _ _Lancer_ \.\.\. calm morning \d/);
    const read = parseLibraryFile(await (saved[0]?.text() ?? '')).library;
    expect(read).toEqual({ models: [slash], settings: [SETTING], flights: [] });
  });

  it('of a library that cannot be read in full says what is missing, and is no export', async () => {
    const store = new MemoryStore();
    const all = store.flights.all.bind(store.flights);
    store.flights.all = () => Promise.reject(new Error('not now'));
    const six = Array.from({ length: 6 }, (_, at) => ({ ...SETTING, id: `s${at}`, name: `s${at}` }));
    for (const setting of six)
      store.settings.records.set(setting.id, { key: setting.id, changedAt: Date.now() - 40 * DAY, setting });
    await library({}, store);
    const saved = downloads();
    await press('Export all…');
    const { partly, without } = en.files.export;
    const holds = countedText({ models: 0, settings: 6, flights: 0 });
    expect(document.querySelector('.notices')?.textContent).toContain(
      partly({ name: shown(saved[0]), what: holds, missing: 'flights' }),
    );
    const read = parseLibraryFile(await (saved[0]?.text() ?? ''));
    expect([read.library.settings.length, read.writtenBy.endsWith(without({ kind: 'flights' }))]).toEqual([6, true]);
    const reminder = () => document.querySelector('.export-reminder');
    expect(reminder(), 'it is still due').not.toBeNull();
    store.flights.all = all;
    await press('Export all…');
    expect(parseLibraryFile(await (saved[1]?.text() ?? '')).writtenBy).not.toContain(without({ kind: 'flights' }));
    expect(reminder()).toBeNull();
  });

  it('of a library of which nothing can be read does not say that there is nothing', async () => {
    const store = new MemoryStore();
    store.settings.all = () => Promise.reject(new Error('not now'));
    await library({}, store);
    const saved = downloads();
    await press('Export all…');
    expect(document.querySelector('.notices')?.textContent).toContain(en.library.unread);
    expect(saved).toEqual([]);
  });

  it('of an empty library is not offered, once all was read', async () => {
    const app = await library({});
    const saved = downloads();
    await press('Export all…');
    expect([saved, button('Export all…').disabled]).toEqual([[], true]);
    await app.session.library.keepModel(MODEL);
    await idle(0);
    expect(button('Export all…').disabled).toBe(false);
  });
});

describe('the reminder to export', () => {
  const old = Date.now() - 40 * DAY;
  const six = Array.from({ length: 6 }, (_, at) => ({ ...SETTING, id: `s${at}`, name: `s${at}` }));
  const reminder = () => document.querySelector('.export-reminder')?.textContent ?? null;

  async function season(changedAt: number, settings = six): Promise<AppBench> {
    const store = new MemoryStore();
    for (const setting of settings) {
      store.settings.records.set(setting.id, { key: setting.id, changedAt, setting });
    }
    return library({}, store);
  }

  it('comes when much was changed long ago and never exported, and an export removes it', async () => {
    await season(old);
    expect(reminder()).toContain(en.files.reminder({ changes: 6 }));
    downloads();
    await press('Export all…');
    expect(reminder()).toBeNull();
  });

  it('does not come for recent changes', async () => {
    await season(Date.now() - 20 * DAY);
    expect(reminder()).toBeNull();
  });

  it('comes for five entries, and not for fewer', async () => {
    await season(old, six.slice(0, 4));
    expect(reminder()).toBeNull();
    cleanup();
    await season(old, six.slice(0, 5));
    expect(reminder()).toContain(en.files.reminder({ changes: 5 }));
  });

  it('counts what has changed since the last export', async () => {
    localStorage.setItem('sidus-timer/library-exported', JSON.stringify({ exportedAt: old - 5 * DAY, putOffAt: null }));
    await season(old);
    expect(reminder()).toContain(en.files.reminder({ changes: 6 }));
  });

  it('comes also where the last export was marked while the clock of the device was years ahead', async () => {
    const ahead = Date.now() + 3000 * DAY;
    localStorage.setItem('sidus-timer/library-exported', JSON.stringify({ exportedAt: ahead, putOffAt: ahead }));
    await season(old);
    expect(reminder()).toContain(en.files.reminder({ changes: 6 }));
  });

  it('does not come for entries that a file has brought to an empty device', async () => {
    await library({});
    const settings = six.map((each) => ({ ...each, at: old }));
    await drop(file(text({ ...ALL, settings, flights: [] }, Date.now() - DAY)));
    await press('Import 7');
    expect(reminder()).toBeNull();
  });

  it('stays after an import among other entries, and after the export of one model', async () => {
    const app = await season(old, [...six, SETTING]);
    await app.session.library.keepModel(MODEL);
    await drop(file(text({ ...ALL, models: [], settings: [] }, Date.now())));
    await press('Import 1');
    downloads();
    act(() => void filesOf(app.models).export({ kind: 'model', id: MODEL.id }, MODEL.name));
    await idle();
    expect(reminder()).not.toBeNull();
  });

  it('is put off for long by one click, also after a reload', async () => {
    const { store } = await season(old);
    await press('Not now');
    expect(reminder()).toBeNull();
    await library({}, store);
    expect(reminder()).toBeNull();
  });
});
