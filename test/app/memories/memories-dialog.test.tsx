import { act, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import type { Backup } from '../../../src/app/storage/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle } from '../bench/bench.js';
import { connected, press, startWrite } from '../screen.js';

const dialog = (name: string) => within(screen.getByRole('dialog', { name }));
const figures = () => document.querySelector('.key-figures')?.textContent.replaceAll('\u00a0', ' ');
const lines = () => within(screen.getByRole('dialog')).getByRole('alert').textContent.replaceAll('\u00a0', ' ');

/** A timer whose third memory has another DT, in front of the dialog that shows the copy of the first one into it. */
async function reviewed(): Promise<AppBench> {
  const app = await connected();
  app.timer.core.memories[2]?.times.splice(10, 1, 36_000);
  await press('Copy M1 to M3');
  return app;
}

describe('copying a memory', () => {
  it('shows the difference like a write, DT and motor stop first, and ends with figures', async () => {
    const { timer } = await reviewed();
    expect(
      screen.getByText(
        'M3 will hold the times and positions of M1, as read just now. What M3 holds now is backed up first. At the end M1 flies next again.',
      ),
    ).toBeTruthy();
    expect(figures()).toBe('DT 3:00 min instead of 6:00 minmotor stop 10.0 s as it is');
    const rows = dialog('Copy M1 to M3')
      .getAllByRole('row')
      .map((row) => [...row.children].map(({ textContent }) => textContent));
    expect(rows).toEqual([
      ['Value', 'Timer holds', 'Will hold'],
      ['DT', '6:00 min', '3:00 min'],
    ]);
    await startWrite();
    expect(lines()).toMatch(/M3 verified \d\d:\d\d · DT 3:00 min · motor stop 10\.0 s · 1 change/);
    expect(dialog('Copy M1 to M3').getByRole('status').textContent).toBe('M1 flies next.');
    expect(timer.core.memories[2]?.times[10]).toBe(18_000);
  });

  it('says which memory flies next after it only while that is known', async () => {
    const { session, timer } = await connected();
    timer.core.memory = 1;
    await press('Copy M1 to M3');
    expect(screen.getByText(/At the end M2 flies next again\.$/), 'another one than on the screen').toBeTruthy();
    act(() => session.nextFlight.doubt());
    expect(screen.queryByText(/flies next again/)).toBeNull();
  });

  it('says before anything is sent which positions no program can send, and writes nothing', async () => {
    const { timer } = await connected();
    (timer.core.content.positions[1] as number[])[3] = 200;
    const held = structuredClone(timer.core.memories[2]);
    await press('Copy M1 to M3');
    const refused = within(screen.getByRole('dialog')).getByRole('alert').textContent;
    expect(refused).toContain(en.memories.refused({ memory: 'M3' }));
    expect(refused).toContain(`Function 3, S2 200: ${en.findings['position-out-of-range']({ min: '0', max: '130' })}`);
    await startWrite();
    expect(screen.getByRole('button', { name: /^Write \d+ changes$/ })).toHaveProperty('disabled', true);
    expect(timer.core.memories[2]).toEqual(held);
    expect(timer.core.answered.filter(({ name }) => name === 'SETSERVO' || name === 'SETTIMERS')).toEqual([]);
  });

  it('copies a position that no program can send where the memory holds the same one', async () => {
    const { timer } = await connected();
    for (const memory of [0, 2]) (timer.core.memories[memory]?.positions[1] as number[])[3] = 200;
    await press('Copy M1 to M3');
    expect(within(screen.getByRole('dialog')).queryByRole('alert')).toBeNull();
    await startWrite();
    expect(timer.core.memories[2]).toEqual(timer.core.memories[0]);
  });

  it('says when it would change nothing', async () => {
    const { timer } = await connected();
    timer.core.memories.splice(1, 1, structuredClone(timer.core.content));
    await press('Copy M1 to M2');
    expect(screen.getByText(en.write.nothing)).toBeTruthy();
    await startWrite();
    expect(lines()).toContain('· 0 changes');
  });

  it('that cannot be backed up says so of that memory, whatever was written into others before', async () => {
    const app = await connected();
    await press(en.overview.readAll);
    for (const memory of app.timer.core.memories) memory.times[10] = 36_000;
    const { store, session, write: job, timer } = app;
    const save = store.backups.save.bind(store.backups);
    let kept = 0;
    store.backups.save = (record) => (kept++ < 1 ? save(record) : Promise.reject(new DOMException('', 'AbortError')));
    const backups = session.backups.list.peek().filter(({ reason }) => reason === 'memories');
    session.safety.confirm();
    void job.open({ kind: 'restore', backups });
    await idle();
    job.goOn();
    await idle();
    expect(timer.core.memories.map(({ times }) => times[10])).toEqual([36_000, 36_000, 36_000, 27_000]);
    expect(screen.getByRole('alert').textContent).toContain(en.write.unkept.advice);
    expect(screen.getByRole('dialog').textContent, 'something was').not.toContain('Nothing was written');
    await press(en.cancel);
    expect(lines()).toContain(en.memories.untouched({ memory: 'M2' }));
  });

  it('says that one memory is not certain, and that another one differs', async () => {
    const { adapter, session, write: job, timer } = await connected();
    await press(en.overview.readAll);
    const [, , second, first] = session.backups.list.peek() as [Backup, Backup, Backup, Backup];
    for (const memory of timer.core.memories) memory.times[10] = 36_000;
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'SETTIMERS') return;
      if (timer.core.memory === 1) adapter.unplug();
      // It acknowledges the value and does not keep it.
      else timer.core.content.times[10] = 36_000;
    };
    session.safety.confirm();
    void job.open({ kind: 'restore', backups: [first, second] });
    await idle();
    job.goOn();
    await idle();
    expect(job.current.value).toMatchObject({
      ends: [
        { memory: 0, state: 'differs' },
        { memory: 1, state: 'unknown' },
      ],
    });
    expect(lines()).toContain(en.write.unknown.title);
    expect(lines()).toContain(en.write.differs.title);
  });

  it('says after an interruption what is not known, and which memory flies next, if that is known', async () => {
    const { timer, adapter } = await reviewed();
    timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && adapter.unplug();
    await startWrite();
    expect(lines()).toContain(`${en.write.unknown.title} ${en.knowledge.noFly}`);
    expect(screen.getByRole('dialog').textContent.replaceAll('\u00a0', ' ')).toContain(
      'It is not known what M3 holds: DT is 6:00 min or 3:00 min. Do not fly before it is read.',
    );
    expect(dialog('Copy M1 to M3').getByRole('status').textContent).toBe(
      'It is not known which memory flies next. When you connected it was M1.',
    );
    screen.getByRole('dialog').dispatchEvent(new Event('cancel', { cancelable: true }));
    await idle(0);
    expect(screen.getByRole('dialog', { name: 'Copy M1 to M3' }), 'Escape does not close the dialog').toBeTruthy();
    await press('Close');
    expect(screen.queryByRole('dialog')).toBeNull();
  });
});
