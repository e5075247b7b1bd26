import { deleteDB, openDB, unwrap } from 'idb';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { cdp } from 'vitest/browser';
import { openStorage, Shelf } from '../../../src/app/storage/database.js';
import { browserStorage, limited, type PortRecord, type Storage } from '../../../src/app/storage/index.js';
import { FLIGHT, MODEL, SETTING } from '../../program/library-examples.js';

function name(): string {
  const own = `test ${Math.random()}`;
  onTestFinished(() => void indexedDB.deleteDatabase(own));
  return own;
}

const PORT = {
  key: 'usb 0403:6001',
  usedAt: 5,
  settings: { baudRate: 'find', dataBits: 8, parity: 'none', stopBits: 1, dtr: null, rts: null },
  foundRate: 9600,
  quirks: { 'timer/Q': { bigEndianTimes: true, positionsNeedMove: true } },
} as const;

describe('the storage of the browser', () => {
  it('gives back what was saved, by key and in the order of the keys, also to the next page', async () => {
    const own = name();
    const shelf = browserStorage(own).ports;
    await shelf.save({ ...PORT, key: 'b' });
    await shelf.save({ ...PORT, key: 'a' });
    await shelf.save({ ...PORT, key: 'b', usedAt: 6 });
    const next = browserStorage(own).ports;
    const b = { ...PORT, key: 'b', usedAt: 6 };
    expect(await next.all()).toEqual([{ ...PORT, key: 'a' }, b]);
    await next.remove('a');
    expect(await shelf.all()).toEqual([b]);
  });

  it('stores at once when the page is left, and no waiting record overwrites that', async () => {
    const shelf = browserStorage(name()).ports;
    const waiting = shelf.save({ ...PORT, usedAt: 6 });
    await Promise.all([shelf.save({ ...PORT, usedAt: 7 }, true), waiting]);
    expect(await shelf.all()).toMatchObject([{ usedAt: 7 }]);
    const late = shelf.save({ ...PORT, usedAt: 8 });
    await Promise.all([shelf.remove(PORT.key), late]);
    expect(await shelf.all()).toEqual([]);
  });

  it('has not kept a record whose newer one it refuses', async () => {
    const shelf = browserStorage(name()).ports;
    // Such a record cannot be stored.
    const refused = { ...PORT, usedAt: 7, extra: () => {} };
    const saves = await Promise.allSettled([shelf.save({ ...PORT, usedAt: 6 }), shelf.save(refused)]);
    expect(saves.map(({ status }) => status)).toEqual(['rejected', 'rejected']);
    expect(await shelf.all()).toEqual([]);
  });

  it('sets aside what cannot be read, once, and keeps it', async () => {
    const own = name();
    const bad = { ...PORT, key: 'a', settings: { baudRate: -1 } };
    const database = await openStorage(own)();
    await database.put('ports', bad);
    await database.put('ports', PORT);
    const storage = browserStorage(own);
    expect(await storage.ports.all()).toEqual([PORT]);
    expect(await storage.ports.all()).toEqual([PORT]);
    expect(await database.getAllKeys('ports')).toEqual([PORT.key]);
    expect(await browserStorage(own).aside.all()).toMatchObject([{ shelf: 'ports', stored: bad }]);
    database.close();
  });

  it('refuses when a newer version of the page has been here', async () => {
    const own = name();
    await new Promise<void>((resolve, reject) => {
      const opening = indexedDB.open(own, 9);
      opening.onsuccess = () => {
        opening.result.close();
        resolve();
      };
      opening.onerror = () => reject(opening.error);
    });
    const { ports } = browserStorage(own);
    const failed = await ports.all().catch((error) => error);
    expect(failed.name).toBe('VersionError');
    await deleteDB(own);
    expect(await ports.all(), 'it can be opened as soon as the reason is gone').toEqual([]);
  });

  it('says so also when a newer version comes while it is open, and is opened again when that one fails', async () => {
    const own = name();
    const shelf = browserStorage(own).ports;
    await shelf.save(PORT);
    const failing = openDB(own, 9, {
      upgrade(_, __, ___, change) {
        change.done.catch(() => {});
        change.abort();
      },
    });
    await expect(failing).rejects.toThrow();
    expect(await shelf.all()).toEqual([PORT]);
    const newer = await openDB(own, 9);
    const failed = await shelf.save({ ...PORT, key: 'a' }).catch((error) => error);
    expect(failed.name).toBe('VersionError');
    newer.close();
  });

  it.each([false, true])(
    'is opened again after the browser has closed it, and says if it is empty: %s',
    async (empty) => {
      const own = name();
      const onEmptied = vi.fn();
      const opened = openStorage(own, onEmptied);
      const shelf = new Shelf<PortRecord>(opened, 'ports');
      await shelf.save(PORT);
      const database = await opened();
      database.close();
      if (empty) await deleteDB(own);
      // As the browser does, which a test cannot make do it.
      unwrap(database).dispatchEvent(new Event('close'));
      expect(await shelf.all()).toEqual(empty ? [] : [PORT]);
      await shelf.save({ ...PORT, key: 'a' });
      expect(await shelf.all()).toContainEqual({ ...PORT, key: 'a' });
      expect(onEmptied).toHaveBeenCalledTimes(empty ? 1 : 0);
    },
  );

  it('says that the browser has deleted it, without another use', async () => {
    const onEmptied = vi.fn();
    await openStorage(name(), onEmptied)();
    const devTools = cdp() as { send(method: string, params: object): Promise<unknown> };
    await devTools.send('Storage.clearDataForOrigin', { origin: location.origin, storageTypes: 'indexeddb' });
    await expect.poll(() => onEmptied.mock.calls.length, { timeout: 5000 }).toBe(1);
  });

  it('can be deleted, also while another tab uses it', async () => {
    const own = name();
    const other = browserStorage(own);
    await other.ports.save(PORT);
    await browserStorage(own).erase();
    expect(await browserStorage(own).ports.all()).toEqual([]);
    await expect(other.ports.save(PORT)).rejects.toThrow();
  });
});

describe('what version 3 has stored', () => {
  const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 3, memories: 4, servos: 1 };
  const was = (dt: number) => ({
    identity: IDENTITY,
    memory: 0,
    timers: [1000, 0, 500, dt],
    positions: [[1, 2, 3, 4]],
    idleThrottle: null,
  });
  const is = (dt: number) => {
    const { timers, ...rest } = was(dt);
    return { ...rest, times: timers };
  };

  it('is read under its new names, nothing of it lost', async () => {
    const own = `test ${Math.random()}`;
    onTestFinished(() => void indexedDB.deleteDatabase(own));
    const old = await openDB(own, 3, {
      upgrade(database) {
        for (const store of ['drafts', 'unfinished', 'backups', 'ports', 'aside']) {
          database.createObjectStore(store, { keyPath: 'key' });
        }
      },
    });
    const step = { name: { code: 'shift', params: { column: 2, by: 50 } }, state: { working: was(3), texts: {} } };
    const draft = {
      key: 'd',
      baseline: was(1),
      working: was(2),
      texts: { 'time:3': '2,3' },
      history: { past: [step], future: [step], open: null },
      savedAt: 5,
      readAt: 4,
      simulated: false,
    };
    const write = {
      key: 'w',
      kind: 'write',
      startedAt: 1,
      before: was(1),
      goal: was(2),
      readAt: 1,
      seenAt: null,
    };
    const walk = { key: 'm', kind: 'memories', startedAt: 1, identity: IDENTITY, home: 2 };
    const backup = { key: 'b', savedAt: 1, reason: 'write', program: was(7), simulated: true };
    // Both had the number of a tab: several could work at the same time.
    await old.put('drafts', { ...draft, tab: 2 });
    await old.put('unfinished', { ...write, tab: 2 });
    await old.put('unfinished', walk);
    await old.put('backups', backup);
    old.close();

    const { drafts, unfinished, backups, aside } = browserStorage(own);
    const newStep = { name: { code: 'shift', params: { slot: 2, by: 50 } }, state: { working: is(3), texts: {} } };
    const history = { past: [newStep], future: [newStep], open: null };
    expect(await drafts.all()).toEqual([{ ...draft, baseline: is(1), working: is(2), history }]);
    const { home, ...rest } = walk;
    expect(await unfinished.all()).toEqual([
      { ...rest, original: home },
      { ...write, before: is(1), goal: is(2) },
    ]);
    expect(await backups.all()).toEqual([{ ...backup, program: is(7) }]);
    expect(await aside.all()).toEqual([]);
  });
});

describe('what each older version has stored', () => {
  const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 3, memories: 4, servos: 1 };
  const was = (times: 'timers' | 'times') => ({
    identity: IDENTITY,
    memory: 0,
    [times]: [1000, 0, 500, 18000],
    positions: [[1, 2, 3, 4]],
    idleThrottle: null,
  });
  const is = was('times');

  it.each([
    [1, ['drafts'], 'timers'],
    [2, ['drafts', 'unfinished', 'backups', 'ports'], 'timers'],
    [3, ['drafts', 'unfinished', 'backups', 'ports', 'aside'], 'timers'],
    [4, ['drafts', 'unfinished', 'backups', 'ports', 'aside'], 'times'],
  ] as const)(
    'version %i: drafts, writes and backups stay where they are, and a library finds its shelves',
    async (version, shelves, times) => {
      const own = `test ${Math.random()}`;
      onTestFinished(() => void indexedDB.deleteDatabase(own));
      const old = await openDB(own, version, {
        upgrade(database) {
          for (const shelf of shelves) database.createObjectStore(shelf, { keyPath: 'key' });
        },
      });
      const draft = { key: 'd', baseline: was(times), working: was(times), texts: { 'time:3': '2,3' }, savedAt: 5 };
      const backup = { key: 'b', savedAt: 1, reason: 'write', program: was(times), simulated: false };
      const write = { key: 'w', kind: 'write', startedAt: 1, before: was(times), goal: was(times) };
      await old.put('drafts', { ...draft, simulated: false });
      const isFirst = version === 1;
      if (!isFirst) await old.put('backups', backup);
      if (!isFirst) await old.put('unfinished', write);
      old.close();

      const storage = browserStorage(own);
      expect(await storage.drafts.all()).toMatchObject([{ key: 'd', baseline: is, working: is, texts: draft.texts }]);
      expect(await storage.backups.all()).toMatchObject(isFirst ? [] : [{ key: 'b', program: is }]);
      expect(await storage.unfinished.all()).toMatchObject(isFirst ? [] : [{ key: 'w', before: is, goal: is }]);
      expect(await storage.aside.all()).toEqual([]);
      const record = { key: MODEL.id, model: MODEL, changedAt: 5, verified: [] };
      const setting = { key: SETTING.id, setting: SETTING, changedAt: 5 };
      const flight = { key: FLIGHT.id, flight: FLIGHT, changedAt: 5 };
      await Promise.all([storage.models.save(record), storage.settings.save(setting), storage.flights.save(flight)]);
      const next = browserStorage(own);
      expect([await next.models.all(), await next.settings.all(), await next.flights.all()]).toEqual([
        [record],
        [setting],
        [flight],
      ]);
    },
  );
});

describe('a library of the first version', () => {
  it('is read as it was, also a servo whose ends were never checked', async () => {
    const own = name();
    const database = await openStorage(own)();
    const use = { duty: 'rudder', name: '', low: 95, high: 20, reversed: false } as const;
    const program = SETTING.program;
    const model = { ...MODEL, servos: [use], archived: true };
    const verified = [{ program, at: 4, simulated: true }];
    const record = { key: MODEL.id, changedAt: 5, verified, model };
    const setting = { key: SETTING.id, changedAt: 5, setting: { ...SETTING, from: 'backup' } };
    const flight = { key: FLIGHT.id, changedAt: 5, flight: FLIGHT };
    const backup = { key: 'b', savedAt: 1, reason: 'write', program, simulated: false, model: MODEL.id };
    // It had a picture and places of its own in the lists.
    await database.put('models', { ...record, order: 2, model: { ...model, photo: 'abcd' } });
    await database.put('settings', { ...setting, order: 1 });
    await database.put('flights', flight);
    await database.put('backups', backup);
    database.close();
    const { models, settings, flights, backups, aside } = browserStorage(own);
    const servos = [{ ...use, low: 20, high: 95 }];
    expect(await models.all()).toEqual([{ ...record, model: { ...model, servos } }]);
    expect([await settings.all(), await flights.all(), await backups.all()]).toEqual([[setting], [flight], [backup]]);
    expect(await aside.all()).toEqual([]);
  });
});

describe('an old version of the page in another tab', () => {
  /** It has something on the only shelf that it knows. */
  async function oldTab(own: string, letsGo: boolean) {
    const old = await openDB(own, 4, {
      upgrade: (database) => void database.createObjectStore('ports', { keyPath: 'key' }),
      blocking: (_, __, event) => letsGo && (event.target as IDBDatabase).close(),
    });
    await old.put('ports', { ...PORT, key: 'old' });
    return old;
  }
  const isGiven = (asked: Promise<unknown>) =>
    asked.then(
      () => true,
      () => false,
    );

  it('that keeps the storage open goes on, and loses nothing', async () => {
    const own = name();
    const old = await oldTab(own, false);
    const { models, ports } = browserStorage(own);
    const given = models.all();
    await old.put('ports', { ...PORT, key: 'typed there' });
    old.close();
    // Without another visit.
    expect(await given).toEqual([]);
    expect((await ports.all()).map(({ key }) => key)).toEqual(['old', 'typed there']);
    await models.save({ key: MODEL.id, model: MODEL, changedAt: 5, verified: [] });
    expect((await browserStorage(own).models.all()).map(({ key }) => key)).toEqual([MODEL.id]);
  });

  it('that closes the storage does not delay this page, and is told that it keeps nothing any more', async () => {
    const own = name();
    const old = await oldTab(own, true);
    const { models, ports } = browserStorage(own);
    expect([await models.all(), (await ports.all()).map(({ key }) => key)]).toEqual([[], ['old']]);
    expect(await isGiven(old.put('ports', PORT))).toBe(false);
    expect(await isGiven(openDB(own, 4)), 'an old page that loads again is refused').toBe(false);
  });
});

describe('a change of the library', () => {
  const model = { key: MODEL.id, model: MODEL, changedAt: 5, verified: [] };
  const setting = { key: SETTING.id, setting: SETTING, changedAt: 5 };
  const flight = { key: FLIGHT.id, flight: FLIGHT, changedAt: 5 };
  const named = (text: string) => ({ ...model, model: { ...MODEL, name: text } });
  const held = async ({ models, settings, flights }: Storage) =>
    (await Promise.all([models.all(), settings.all(), flights.all()])).map((records) => records.map(({ key }) => key));
  const nameIn = async (storage: Storage) => (await storage.models.all())[0]?.model.name;

  it('puts and deletes records of several kinds', async () => {
    const storage = browserStorage(name());
    await storage.change({ models: { put: [model] }, settings: { put: [setting] } });
    expect(await held(storage)).toEqual([[MODEL.id], [SETTING.id], []]);
    await storage.change({ models: { gone: [MODEL.id] }, flights: { put: [flight] }, settings: {} });
    expect(await held(storage)).toEqual([[], [SETTING.id], [FLIGHT.id]]);
    await storage.change({});
  });

  it('is kept whole or not at all', async () => {
    const storage = browserStorage(name());
    await storage.change({ models: { put: [model] } });
    const bad = { ...setting, key: () => {} } as never;
    await expect(storage.change({ models: { gone: [MODEL.id] }, settings: { put: [bad] } })).rejects.toThrow();
    expect(await held(storage)).toEqual([[MODEL.id], [], []]);
  });

  it('is sent at once when the page is left, after those that wait for their turn', async () => {
    const own = name();
    const storage = limited(browserStorage(own), { heard: () => {} });
    await storage.change({ models: { put: [model] } });
    const sent = [1, 2, 3].map((each) => storage.change({ models: { put: [named(`typed ${each}`)] } }));
    dispatchEvent(new PageTransitionEvent('pagehide'));
    sent.push(storage.change({ models: { put: [named('typed last')] } }));
    await Promise.resolve();
    await Promise.resolve();
    const next = browserStorage(own);
    await expect.poll(() => nameIn(next)).toBe('typed last');
    dispatchEvent(new PageTransitionEvent('pageshow'));
    await Promise.all(sent);
    expect(await nameIn(next)).toBe('typed last');
  });
});
