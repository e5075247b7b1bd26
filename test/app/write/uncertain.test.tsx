import { fireEvent, screen, within } from '@testing-library/preact';
import { beforeEach, describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, idle, MemoryStore } from '../bench/bench.js';
import { button, connected, late, loadedAgain, press, startWrite, type } from '../screen.js';

const SENTENCE = 'It is not known what M1 holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.';
const ELSEWHERE = SENTENCE.replace('M1', 'M1 of the F1Q 536');

function band(): string | null {
  return screen.queryByRole('region', { name: 'Not certain' })?.textContent ?? null;
}

function described(name: string): string[] {
  const ids = screen.getByRole('textbox', { name }).getAttribute('aria-describedby')?.split(' ') ?? [];
  return ids.map((id) => document.getElementById(id)?.textContent ?? '');
}

async function write(): Promise<void> {
  await press('Write…');
  await startWrite();
}

/** DT 6:00 is written, and the cable is pulled before the answer: the timer holds 6:00. */
async function cut(): Promise<AppBench> {
  const bench = await connected({ store: new MemoryStore() });
  await type('DT time', '6:00');
  bench.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && bench.adapter.unplug();
  await write();
  bench.timer.core.onAnswer = undefined;
  expect(bench.timer.core.content.times[10]).toBe(36_000);
  return bench;
}

describe('after a write whose answer never came', () => {
  let bench: AppBench;
  beforeEach(async () => {
    bench = await cut();
  });

  it('the dialog and the page say what is not known, and nothing false', async () => {
    expect(screen.getByRole('dialog').textContent).toContain(en.write.unknown.title);
    expect(screen.getByRole('dialog').textContent, 'the band is shown over the dialog, too').toContain(SENTENCE);
    await press('Close');
    expect(band()).toContain(ELSEWHERE);
    expect(
      screen.getByText('Not known what M1 holds'),
      'the page says this in place of the number of changes',
    ).toBeTruthy();
    expect(screen.queryByText('was 3:00')).toBeNull();
    expect(described('DT time')).toContain('last read 3:00 min, not certain now');
    expect(document.body.textContent).not.toContain('Timer holds');
    expect(document.querySelector('.uncertain-behind .overlay')).not.toBeNull();
    expect(screen.getByText(/^Marked fields differ from what was last read/)).toBeTruthy();
  });

  it('the dialog follows the reading once the timer is back', async () => {
    bench.adapter.replug();
    await idle();
    const said = screen.getByRole('dialog').textContent;
    expect(said).toContain(
      'The write into M1 was interrupted. The timer was read again and holds all that was to be written.',
    );
    expect([said?.includes(en.write.unknown.title), said?.includes(en.link.lost.title)]).toEqual([false, false]);
    expect(screen.queryByRole('button', { name: 'Write again…' }), 'nothing is missing').toBeNull();
  });

  it('the dialog shows what is missing, and writes it in its place', async () => {
    bench.timer.core.content.times[10] = 18_000;
    bench.adapter.replug();
    await idle();
    const said = screen.getByRole('dialog').textContent;
    expect(said).toContain('The timer holds what it held before: nothing was written, 1 change is missing.');
    expect([said?.includes(en.write.unknown.title), said?.includes(en.link.lost.title)]).toEqual([false, false]);
    await press('Write again…');
    await startWrite();
    expect(screen.getByRole('alert').textContent).toContain('Verified.');
    expect(bench.timer.core.content.times[10]).toBe(36_000);
  });

  it('the dialog still says that it is not known where the reading does not fit the write', async () => {
    bench.timer.core.content.times[10] = 12_000;
    bench.adapter.replug();
    await idle();
    const said = screen.getByRole('dialog').textContent;
    expect([said?.includes(en.write.unknown.title), said?.includes(en.link.lost.title)]).toEqual([true, false]);
  });

  it('only the figures that it was to change are red; the others are as last read', async () => {
    await press('Close');
    const figures = [...document.querySelectorAll('.strip-figure')];
    expect(figures.map(({ className, textContent }) => `${textContent}: ${className}`)).toEqual([
      'DT 6:00 min: strip-figure bad',
      'motor stop 10.0 s: strip-figure past',
    ]);
  });

  it('it stays through Close, Stop, Undo all and Disconnect', async () => {
    await press('Close');
    expect(band()).toContain(ELSEWHERE);
    await press('Undo all');
    expect(band()).toContain(ELSEWHERE);
    expect(screen.getByText('Not known what M1 holds')).toBeTruthy();
    expect(screen.queryByText(/As in the timer|No change/)).toBeNull();
    expect(
      screen.queryByRole('button', { name: en.knowledge.forget }),
      'not while the adapter is waited for',
    ).toBeNull();
    await press(en.header.stop);
    expect(band()).toContain(ELSEWHERE);
    expect(button(en.knowledge.forget)).toBeTruthy();
  });

  it.each(['with the edits', 'with nothing on the screen'])('it stays through a reload, %s', async (how) => {
    await press('Close');
    if (how === 'with nothing on the screen') {
      bench.editor.clear();
      bench.store.drafts.records.clear();
    }
    await loadedAgain(bench);
    expect(band()).toContain(ELSEWHERE);
    expect(document.body.textContent).not.toMatch(/They have not been written|As in the timer/);
    if (how === 'with the edits') {
      expect(screen.getByText(/It is not known whether they were written\./)).toBeTruthy();
    }
  });

  it('it goes by a fresh reading, which says what the timer holds', async () => {
    await press('Close');
    bench.adapter.replug();
    await idle();
    expect(band()).toBeNull();
    expect(screen.getByText(/^As in the timer, read/)).toBeTruthy();
    expect(screen.getByText(en.notes['write-completed'].title)).toBeTruthy();
  });

  it('it stays when the reading is not explained, and the pilot says which timer it is', async () => {
    const after = await loadedAgain(bench);
    (after.timer.core.content.positions[1] as number[])[5] = 77;
    await press(en.knowledge.connect);
    expect(band()).toContain(SENTENCE);
    expect(screen.getByText(/neither old nor from that write/)).toBeTruthy();
    expect(document.body.textContent).not.toContain('The timer holds');
    await press(en.recovery.otherTimer);
    expect(band()).toContain(SENTENCE.replace('M1', 'M1 of another F1Q 536'));
    expect(screen.queryByRole('button', { name: en.knowledge.connect })).toBeNull();
  });

  it('it goes when the pilot says so, after a question', async () => {
    await press('Close');
    await press(en.header.stop);
    await press(en.knowledge.forget);
    expect(band()).toContain('Forget it only if you have read that timer elsewhere');
    await press(en.cancel);
    expect(band()).toContain(ELSEWHERE);
    await press(en.knowledge.forget);
    await press(en.knowledge.forgetNow);
    expect([band(), bench.store.unfinished.records.size]).toEqual([null, 0]);
    await press('Undo all');
    expect(screen.getByText('As last read')).toBeTruthy();
  });
});

it('a write that was read back in part can be read again from the band', async () => {
  const bench = await connected();
  await type('DT time', '6:00');
  bench.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && button('Stop').click();
  await write();
  bench.timer.core.onAnswer = undefined;
  const dialog = within(screen.getByRole('dialog'));
  expect(dialog.getByText(SENTENCE), 'the band is shown over the dialog, too').toBeTruthy();
  expect(dialog.queryAllByText(/not known not known/)).toEqual([]);
  await press('Close');
  expect(band()).toContain(SENTENCE);
  fireEvent.click(
    within(screen.getByRole('region', { name: 'Not certain' })).getByRole('button', { name: 'Read again' }),
  );
  await idle();
  expect(band()).toBeNull();
});

describe('the words for what is known', () => {
  const compared = () => document.querySelector('.timeline-behind')?.textContent;

  it('is “was” while the timer is there, and “last read” when it is not', async () => {
    const { adapter } = await connected();
    await type('DT time', '6:00');
    expect(described('DT time')).toContain('was 3:00 min');
    await late();
    expect(compared()).toBe('Timer holds');
    adapter.unplug();
    await idle();
    expect(described('DT time')).toContain('last read 3:00 min');
    await late();
    expect(compared()).toBe('Last read');
    expect(document.body.textContent).not.toContain('Timer holds');
    expect(screen.getByText(/^Marked fields differ from what was last read, \d\d:\d\d\.$/)).toBeTruthy();
    await press('Undo all');
    expect(screen.getByText(/^As last read \d\d:\d\d$/)).toBeTruthy();
  });

  it('is as in the timer when it was read, verified when it was written, until something changes', async () => {
    await connected();
    expect(screen.getByText(/^As in the timer, read \d\d:\d\d$/)).toBeTruthy();
    await type('DT time', '6:00');
    expect(screen.queryByText(/^As in the timer/)).toBeNull();
    await write();
    await press('Close');
    expect(screen.getByText(/^As in the timer, verified \d\d:\d\d$/)).toBeTruthy();
    expect(band()).toBeNull();
    await type('DT time', 'x');
    expect(screen.queryByText(/^As in the timer/)).toBeNull();
    expect(screen.getByText('1 field has no value yet')).toBeTruthy();
  });

  it('is kept with the edits through a reload', async () => {
    const bench = await connected();
    await type('DT time', '6:00');
    await loadedAgain(bench);
    expect(described('DT time')).toContain('last read 3:00 min');
    expect(screen.getByText(/^Marked fields differ from what was last read, \d\d:\d\d\.$/)).toBeTruthy();
    expect(document.body.textContent).not.toMatch(/They have not been written|not known whether/);
  });
});

describe('the dialog of a write', () => {
  it('begins at its top, with DT and the motor stop and the focus on its heading', async () => {
    await connected();
    await type('Function 2, S1', '7');
    await press('Write…');
    const dialog = screen.getByRole('dialog');
    expect(document.activeElement).toBe(within(dialog).getByRole('heading', { name: en.write.title }));
    expect(dialog.querySelector('.key-figures')?.textContent).toBe('DT 3:00 min as it ismotor stop 10.0 s as it is');
  });

  it('says once that this device keeps no copy, and asks', async () => {
    const bench = await connected();
    await type('DT time', '6:00');
    bench.store.broken = true;
    await write();
    expect(screen.getByRole('dialog').textContent).toContain(en.write.unkept.title);
    await press(en.write.withoutCopy);
    expect(bench.timer.core.content.times[10]).toBe(36_000);
    expect(screen.getByRole('alert').textContent).toMatch(/M1\sverified\s.*\s· DT\s6:00\smin\s· .*\s· 1\schange$/);
  });
});
