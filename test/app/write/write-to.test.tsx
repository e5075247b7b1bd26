import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, idle, sets } from '../bench/bench.js';
import { connected, field, key, press, startWrite, type } from '../screen.js';

const dialog = () => within(screen.getByRole('dialog', { name: en.write.title }));
const text = () => screen.getByRole('dialog').textContent.replaceAll('\u00a0', ' ');
const kept = ({ session }: AppBench) => session.backups.list.value.map(({ program }) => program.memory);

async function choose(memory: string): Promise<void> {
  fireEvent.click(dialog().getByRole('radio', { name: memory }));
  await idle();
}

/** DT of M1 is changed to 4:00, and the dialog shows what that would change in M3, where DT is 6:00. */
async function reviewed(): Promise<AppBench> {
  const app = await connected();
  app.timer.core.memories[2]?.times.splice(10, 1, 36_000);
  await type('DT time', '4:00');
  await press('Write 1 change…');
  await choose('M3');
  return app;
}

it('arrow keys walk along the memories, and nothing is read before one is chosen', async () => {
  const app = await connected();
  await type('DT time', '4:00');
  await press('Write 1 change…');
  const radio = (name: string) => dialog().getByRole<HTMLInputElement>('radio', { name });
  app.timer.core.answered.length = 0;
  radio('M1').focus();
  for (const [pressed, at] of [
    ['ArrowRight', 'M2'],
    ['ArrowDown', 'M3'],
    ['ArrowLeft', 'M2'],
    ['ArrowUp', 'M1'],
    ['ArrowLeft', 'M4'],
    ['ArrowRight', 'M1'],
    ['ArrowRight', 'M2'],
  ] as const) {
    expect(fireEvent.keyDown(document.activeElement as Element, { key: pressed }), 'the browser chooses none').toBe(
      false,
    );
    expect(document.activeElement).toBe(radio(at));
  }
  await idle();
  expect([app.timer.core.answered.length, radio('M1').checked]).toEqual([0, true]);
  await key('Enter');
  expect(radio('M2').checked).toBe(true);
  expect(text()).toContain('M2 will hold');
});

describe('writing the program on the screen to another memory', () => {
  it('shows what changes there, writes it, verifies, and comes back; the changes of M1 stay', async () => {
    const app = await reviewed();
    const before = structuredClone(app.timer.core.memories);
    expect(
      screen.getByText(
        'M3 will hold the times and positions on the screen. What M3 holds now is backed up first. At the end M1 flies next again.',
      ),
    ).toBeTruthy();
    expect(document.querySelector('.key-figures')?.textContent).toContain('DT 4:00');
    expect([...dialog().getAllByRole('row')].at(-1)?.textContent.replaceAll('\u00a0', ' ')).toBe('DT6:00 min4:00 min');
    await startWrite();
    expect(text()).toMatch(/Verified\..*M3 verified \d\d:\d\d · DT 4:00 min · motor stop 10\.0 s · 1 change/);
    expect(dialog().getByRole('status').textContent).toBe('M1 flies next.');
    const { timer, editor, session, store } = app;
    expect(timer.core.memories[2]).toEqual({
      ...before[0],
      times: before[0]?.times.map((time, at) => (at === 10 ? 24_000 : time)),
    });
    expect([timer.core.memories[0], timer.core.memory]).toEqual([before[0], 0]);
    expect(kept(app)).toEqual([2]);
    expect(store.unfinished.records.size).toBe(0);
    await press('Close');
    expect([field('DT time').value, editor.changes.value.length]).toEqual(['4:00', 1]);
    expect(session.knowledge.of(2)).toMatchObject({ state: 'read', verified: true });
    expect(session.knowledge.of(0)).toMatchObject({ state: 'read', verified: false });
    expect(editor.confirmed.value, 'no value of M1 is called confirmed').toEqual(new Set());
  });

  it('goes back to M1 in the same dialog, by a fresh reading', async () => {
    const { timer } = await reviewed();
    timer.core.memories[0]?.times.splice(10, 1, 12_000);
    await choose('M1');
    expect(text()).toContain(en.write.lead({ memory: 'M1' }));
    expect([...dialog().getAllByRole('row')].at(-1)?.textContent.replaceAll('\u00a0', ' ')).toBe('DT2:00 min4:00 min');
    await startWrite();
    expect([timer.core.memories[0]?.times[10], timer.core.memories[2]?.times[10]]).toEqual([24_000, 36_000]);
  });

  it('writes nothing by a choice alone, also where everything is ticked', async () => {
    const app = await reviewed();
    app.session.safety.confirm();
    for (const memory of ['M1', 'M2', 'M3', 'M1']) await choose(memory);
    app.write.writeTo(0);
    await idle();
    expect(sets(app).filter((name) => name !== 'SETMEMORY')).toEqual([]);
  });

  it('asks for a tick at what may cost the model, above the difference', async () => {
    const app = await connected();
    await type('Motor stop time', '5:00');
    await press('Write 1 change…');
    await choose('M3');
    expect(text()).toContain(en.write.acknowledge);
    await startWrite();
    expect(sets(app)).not.toContain('SETTIMERS');
    fireEvent.click(dialog().getByRole('checkbox', { name: en.write.acknowledge }));
    await press(/^Write \d+ changes?$/);
    expect(app.timer.core.memories[2]?.times[0]).toBe(30_000);
  });

  it('shows it once more when the program has changed, or M3', async () => {
    const app = await reviewed();
    app.session.safety.confirm();
    app.editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
    await idle(0);
    await press(/^Write \d+ changes?$/);
    expect(text()).toContain(en.write.moved.edits.title);
    expect(sets(app)).not.toContain('SETTIMERS');
    app.timer.core.memories[2]?.times.splice(9, 1, 1234);
    await press(/^Write \d+ changes?$/);
    expect(text()).toContain(en.timer.stale.title);
    expect(sets(app)).not.toContain('SETTIMERS');
    await press(/^Write \d+ changes?$/);
    expect(app.timer.core.memories[2]?.positions[0]?.[2]).toBe(7);
  });

  it('leaves the idle throttle, which may belong to all memories, and says so', async () => {
    const app = await connected();
    await type('Idle throttle', '44');
    await press('Write 1 change…');
    await choose('M3');
    expect(text()).toContain('The idle throttle stays as it is.');
    await startWrite();
    expect([app.timer.core.idleThrottle, app.editor.changes.value.length]).toEqual([30, 1]);
  });

  it('is no choice where nobody knows which memory to come back to, or there is only one', async () => {
    await connected({ quirks: { memoryReplyEmpty: true } });
    await press('Write…');
    expect(dialog().queryByRole('radio')).toBeNull();
  });

  it('is a list of one line for more than eight memories', async () => {
    const app = await connected({ identity: { timerClass: 'Q', memories: 20 } });
    await press('Write…');
    fireEvent.change(dialog().getByRole('combobox', { name: en.write.target }), { target: { value: '11' } });
    await idle();
    expect(app.write.current.value).toMatchObject({ step: 'review', changes: [{ memory: 11 }] });
  });
});
