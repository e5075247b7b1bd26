import { act, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import { messages } from '../../../../src/app/messages/index.js';
import { linkOf, sharedOf } from '../../../../src/app/work/setting-link.js';
import type { SharedSetting } from '../../../../src/program/index.js';
import { MODEL, SETTING } from '../../../program/library-examples.js';
import { en } from '../../../tools/en.js';
import { type AppBench, idle, MemoryStore } from '../../bench/bench.js';
import { connected, opened, press } from '../../screen.js';

const SHARED = sharedOf(SETTING, MODEL);
const PAGE = 'https://pilot.example/';
const dialog = () => within(screen.getByRole('dialog'));
const isOpen = () => screen.queryByRole('dialog') !== null;

async function comes({ sharing }: AppBench, shared: SharedSetting | string = SHARED): Promise<void> {
  act(() => sharing.take(typeof shared === 'string' ? shared : linkOf(shared, PAGE)));
  await idle(0);
}

/** What the timer at hand could hold: the same values with another DT. */
function shiftedDt({ editor }: AppBench): SharedSetting {
  const program = editor.working.value;
  if (!program) throw new Error('nothing is on the screen');
  return { ...SHARED, program: { ...program, times: [...program.times.slice(0, -1), 24_000] } };
}

describe('a setting that is shared', () => {
  it('can be copied as a link, shown as a QR code, and shared by the system where it can', async () => {
    const { sharing } = await opened();
    const sent: unknown[] = [];
    const copied: string[] = [];
    vi.stubGlobal('navigator', {
      share: async (what: unknown) => void sent.push(what),
      clipboard: { writeText: async (text: string) => void copied.push(text) },
    });
    act(() => sharing.offer(SHARED));
    await idle(0);
    const link = dialog().getByRole<HTMLInputElement>('textbox', { name: 'Link' }).value;
    expect(link).toBe(linkOf(SHARED, location.href));
    expect(dialog().getByRole('img', { name: 'QR code of “calm morning”' })).toBeTruthy();
    await press('Share…');
    await press('Copy link');
    expect([sent, copied]).toEqual([[{ title: 'calm morning', url: link }], [link]]);
    vi.unstubAllGlobals();
    await press('Close');
    expect(isOpen()).toBe(false);
  });

  it('says what does not fit in the code', async () => {
    const { sharing } = await opened();
    act(() => sharing.offer({ ...SHARED, note: 'n'.repeat(2000) }));
    await idle(0);
    expect(dialog().getByText(en.share.offer.cut)).toBeTruthy();
  });
});

describe('a setting that comes by link', () => {
  it('can be pasted with the message around it, and nothing else is taken', async () => {
    const bench = await opened();
    act(() => bench.sharing.paste());
    await idle(0);
    const field = () => dialog().getByRole('textbox', { name: en.share.offer.link });
    fireEvent.input(field(), { target: { value: 'https://pilot.example/#library' } });
    await press(en.share.paste.show);
    expect(dialog().getByRole('alert').textContent).toBe(en.share.paste.notLink);
    fireEvent.input(field(), { target: { value: `For Sunday: ${linkOf(SHARED, PAGE)} See you` } });
    await press(en.share.paste.show);
    expect(screen.getByRole('dialog', { name: en.share.received.title })).toBeTruthy();
    expect(dialog().getByText('calm morning')).toBeTruthy();
  });

  it('is shown with all its values, and nothing happens without a click', async () => {
    const bench = await opened();
    await comes(bench);
    expect(dialog().getByText('calm morning')).toBeTruthy();
    expect(dialog().getAllByText(/Lancer 07/).length).toBeGreaterThan(0);
    const place = dialog().getByRole('combobox', { name: en.share.received.modelChoice });
    const values = dialog().getByRole('table');
    const order = place.compareDocumentPosition(values);
    expect(order, 'where it would go stands above the values').toBe(Node.DOCUMENT_POSITION_FOLLOWING);
    const rows = dialog()
      .getAllByRole('row')
      .map((row) => [...row.children].map((cell) => cell.textContent).join(' '));
    expect(rows).toEqual([
      'Function Time S1 S2',
      'Start 0 15 15',
      'Function 1 0.3 s 25 15',
      'Motor stop 10.0 s  ',
      'Function 2 10.5 s 40 60',
      'Function 3 13.0 s 55 70',
      'DT 3:00 min 115 115',
    ]);
    await press('Do not keep');
    expect(isOpen()).toBe(false);
    expect([bench.session.library.settings.list.value, bench.editor.working.value]).toEqual([[], null]);
  });

  it('is kept under a new model of its name, and shown there', async () => {
    const bench = await opened();
    const { library } = bench.session;
    await comes(bench);
    expect(dialog().getByText(en.share.received.lead)).toBeTruthy();
    await press(en.share.received.keep);
    const [model] = library.models.list.value;
    const [kept] = library.settings.list.value;
    expect(model?.model).toMatchObject({ name: 'Lancer 07', timerClass: 'Q' });
    expect(kept?.setting).toEqual({ ...SETTING, id: kept?.key, from: 'link', model: model?.key });
    expect([bench.views.shown.value, bench.views.path.value]).toEqual(['library', `${model?.key}/${kept?.key}`]);
    expect(isOpen()).toBe(false);
  });

  it.each<[names: string, shared: SharedSetting]>([
    ['as they are', SHARED],
    [
      'that would turn a sentence round',
      { ...SHARED, name: `\u202e${SHARED.name}`, modelName: `${MODEL.name}\u2066`, tags: ['\u202d'] },
    ],
  ])(
    'goes under the model of that name if there is one, and says when the values are known: names %s',
    async (_, shared) => {
      const bench = await opened();
      const { library } = bench.session;
      await library.keepModel(MODEL);
      await library.keepSetting(SETTING);
      await comes(bench, shared);
      expect(dialog().getByRole<HTMLSelectElement>('combobox', { name: en.share.received.modelChoice }).value).toBe(
        MODEL.id,
      );
      expect(dialog().getByText(/has these values already: Lancer 07 · calm morning/)).toBeTruthy();
      expect(screen.getByRole('dialog').textContent).not.toMatch(/[\u202a-\u202e\u2066-\u2069]|Tags/);
      await press(en.share.received.keep);
      expect(library.models.list.value).toHaveLength(1);
      expect(library.settings.list.value.map(({ setting }) => setting.model)).toEqual([MODEL.id, MODEL.id]);
      expect(library.settings.get(SETTING.id)?.setting).toEqual(SETTING);
    },
  );

  it('waits until the library was read, so that no model is made twice', async () => {
    const store = new MemoryStore();
    await store.models.save({ key: MODEL.id, model: MODEL, changedAt: 1, verified: [] });
    const all = store.models.all.bind(store.models);
    let answer = (): void => {};
    vi.spyOn(store.models, 'all').mockImplementation(async () => {
      await new Promise<void>((resolve) => {
        answer = resolve;
      });
      return all();
    });
    const bench = await opened({ store });
    await comes(bench);
    const keep = () => screen.getByRole<HTMLButtonElement>('button', { name: en.share.received.keep });
    expect(keep().disabled).toBe(true);
    answer();
    await idle(0);
    expect(keep().disabled).toBe(false);
    await press(en.share.received.keep);
    expect(bench.session.library.models.list.value.map(({ key }) => key)).toEqual([MODEL.id]);
  });

  it('says that it will be lost on closing the page when nothing can be kept', async () => {
    const bench = await opened();
    await comes(bench);
    bench.store.broken = true;
    await press(en.share.received.keep);
    expect(screen.getByText(en.keeping.notKept, { exact: false })).toBeTruthy();
  });

  it('is opened without a timer', async () => {
    const bench = await opened();
    await comes(bench);
    await press('Open');
    expect([isOpen(), bench.views.shown.value]).toEqual([false, 'program']);
    expect(bench.editor.working.value?.times).toEqual(SETTING.program.times);
  });

  it('comes over what a timer holds as one step that undo takes back, and sends nothing', async () => {
    const bench = await connected();
    const held = structuredClone(bench.timer.core.memories);
    const before = bench.editor.working.value;
    await comes(bench, shiftedDt(bench));
    await press(messages.value.open);
    expect(bench.editor.working.value?.times.at(-1)).toBe(24_000);
    expect(bench.timer.core.memories).toEqual(held);
    act(() => bench.editor.undo());
    expect(bench.editor.working.value).toEqual(before);
  });

  it('cannot be loaded over a timer of another layout', async () => {
    const bench = await connected();
    await comes(bench, {
      ...SHARED,
      program: { ...SETTING.program, identity: { ...SETTING.program.identity, timerClass: 'B' } },
    });
    expect(screen.getByRole<HTMLButtonElement>('button', { name: messages.value.open }).disabled).toBe(true);
    expect(dialog().getByText(messages.value.notFitting)).toBeTruthy();
  });

  it('waits until an open question is answered', async () => {
    const bench = await connected();
    act(() => void bench.editor.type({ kind: 'time', slot: 10 }, '4:00'));
    await press('Write…');
    await comes(bench);
    expect(screen.getAllByRole('dialog')).toHaveLength(1);
    expect(screen.queryByText(en.share.received.title)).toBeNull();
    await press('Cancel');
    expect(dialog().getByText(en.share.received.title)).toBeTruthy();
  });

  it.each(['#s=', '#s=AVEYAgoEAwMADOgD', linkOf(SHARED, PAGE).slice(0, -3), `#s=${'A'.repeat(70_000)}`])(
    'is refused when it is damaged (%#)',
    async (link) => {
      const bench = await opened();
      await comes(bench, link);
      expect(dialog().getByRole('alert').textContent).toContain(en.share.damaged.bad);
      await press('Close');
      expect([isOpen(), bench.session.library.settings.list.value]).toEqual([false, []]);
    },
  );
});
