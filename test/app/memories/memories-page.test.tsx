import { act, cleanup, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import type { TimerProgram } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, type BenchOptions, idle } from '../bench/bench.js';
import { button, connected, goTo, lookAt, opened, press } from '../screen.js';

async function atMemories(options: BenchOptions = {}): Promise<AppBench> {
  const app = await connected(options);
  await goTo('memories');
  return app;
}

/** With all memories read and kept. */
async function read(): Promise<AppBench> {
  const app = await atMemories();
  await press(en.overview.readAll);
  return app;
}

const card = (memory: string): HTMLElement => screen.getByRole('article', { name: memory });

/** What a card says above its picture. */
function said(memory: string): (string | undefined)[] {
  return [...card(memory).querySelectorAll('.badge, .card-figures span, .hint, .bad-text')].map(({ textContent }) =>
    textContent?.trim(),
  );
}

/** The buttons of a card, by what is read aloud. */
function buttons(memory: string): (string | null)[] {
  return within(card(memory))
    .getAllByRole('button')
    .filter((each) => !each.closest('.copy-to'))
    .map((each) => each.getAttribute('aria-label') ?? each.textContent);
}

describe('the memories', () => {
  it('are cards: what was read of each, and what can be done with it', async () => {
    await read();
    const now = expect.stringMatching(/^read \d+:\d\d/);
    expect(said('M1')).toEqual(['flies next', 'DT 3:00 min', 'motor stop 10.0 s', now]);
    expect(said('M2')).toEqual(['DT 3:30 min', 'motor stop 10.0 s', now]);
    expect(document.querySelectorAll('.memory-card .small-lanes')).toHaveLength(4);
    expect(buttons('M1')).toEqual(['Open: M1', 'Compare with M2: M1']);
    expect(buttons('M3')).toEqual(['Edit M3', 'Make M3 fly next', 'Compare with M1: M3']);
  });

  it('have one time axis: the later DT lies further on, and motor runs of one length are as long', async () => {
    await read();
    /** Where the picture of a memory has its DT, or the end of its motor run or of a servo. */
    const place = (line: 'flag-line' | 'motor-bar' | 'servo-line') => (memory: string) => {
      const path = card(memory).querySelector(`.${line}`)?.getAttribute('d') ?? '';
      return Number((line === 'flag-line' ? /^M([\d.]+)/ : /H([\d.]+)$/).exec(path)?.[1]);
    };
    // Motor stop 10.0 s in all; DT 3:00, 3:30 and 4:00 min.
    const [motor, ...others] = ['M1', 'M2', 'M3'].map(place('motor-bar'));
    expect(motor).toBeGreaterThan(0);
    expect(others).toEqual([motor, motor]);
    const dt = ['M1', 'M2', 'M3'].map(place('flag-line'));
    expect(dt).toEqual(dt.toSorted((a, b) => a - b));
    expect(new Set(dt).size).toBe(3);
    const ends = ['M1', 'M2', 'M3'].map(place('servo-line'));
    expect(ends.map((end, at) => end - (dt[at] as number) > 20)).toEqual([true, true, true]);
  });

  it('say in words and in red that a DT is short, also where one of them is looked at', async () => {
    const { models } = await read();
    models.preferences.setShortDt(22_000);
    await idle(0);
    const red = () => [...document.querySelectorAll('.view .bad-text')].map(({ textContent }) => textContent);
    expect(red()).toEqual(['Short DT 3:00 min', 'Short DT 3:30 min']);
    await goTo('program');
    await lookAt('M2');
    expect(red()).toEqual(['Short DT 3:30 min']);
    await lookAt('M3');
    expect(red()).toEqual([]);
  });

  it('say when they were not read; one click reads one, goes back, and leaves the program as it was', async () => {
    const { timer, memories } = await atMemories();
    expect(said('M3')[0]).toBe(en.look.notRead({ memory: 'M3' }));
    expect(buttons('M3')).toEqual(['Look at M3', 'Edit M3', 'Make M3 fly next']);
    const look = button('Look at M3');
    look.focus();
    const focus = vi.spyOn(HTMLElement.prototype, 'focus');
    await press('Look at M3');
    expect(focus.mock.calls, 'the page stays where the pilot has scrolled meanwhile').toEqual([
      [{ preventScroll: true }],
    ]);
    expect(said('M3')[0]).toBe('DT 4:00 min');
    expect(look.isConnected, 'the button has done its work').toBe(false);
    expect(document.activeElement, 'the focus goes on to').toBe(button('Edit M3'));
    expect([timer.core.memory, memories.looking.value]).toEqual([0, null]);
  });

  it('can be made to fly next there', async () => {
    const { timer } = await read();
    button('Make M3 fly next').focus();
    await press('Make M3 fly next');
    expect(document.activeElement).toBe(button('Open: M3'));
    expect(timer.core.memory).toBe(2);
    expect([said('M1')[0], said('M3')[0]]).toEqual(['DT 3:00 min', 'flies next']);
    expect(buttons('M3')).not.toContain('Make M3 fly next');
  });

  it('are opened in the table, whichever flies next', async () => {
    const { models, memories, session } = await read();
    const shown = () => [models.views.shown.value, memories.looking.value, session.onScreen.memory.value];
    await press('Edit M3');
    expect(shown()).toEqual(['program', null, 2]);
    await goTo('memories');
    await press('Open: M1');
    expect(shown()).toEqual(['program', null, 0]);
    await goTo('memories');
    await press('Disconnect');
    await press('Open: M3');
    expect(shown(), 'as last read').toEqual(['program', 2, 0]);
  });

  it('are not certain since a write into one was cut off: both values stand there', async () => {
    const { session } = await read();
    const before = { ...(session.editor.baseline.value as TimerProgram), memory: 2 };
    const times = before.times.map((time, slot) => (slot === 10 ? 36_000 : time));
    await session.knowledge.begin(before, { ...before, times });
    session.knowledge.jobOver();
    await idle(0);
    expect(said('M3')).toEqual(['DT 3:00 min or 6:00 min', 'motor stop 10.0 s', en.overview.notCertain]);
  });

  it('cannot be looked at where the timer does not say which is current, but made to fly next', async () => {
    const { timer } = await atMemories({ quirks: { memoryReplyEmpty: true } });
    expect(button('Look at M2').getAttribute('aria-disabled')).toBe('true');
    expect(screen.getAllByText(en.timer['memory-unknown'].advice).length).toBeGreaterThan(0);
    await press('Look at M2');
    expect(timer.core.answered.filter(({ name }) => name === 'SETMEMORY')).toEqual([]);
    await press('Make M2 fly next');
    expect(timer.core.memory).toBe(1);
  });

  it('do not say so of a timer that was unplugged during a look', async () => {
    const { timer, adapter } = await atMemories();
    timer.core.onAnswer = ({ name }) => name === 'SETMEMORY' && adapter.unplug();
    await press('Look at M3');
    expect(document.body.textContent).not.toContain(en.timer['memory-unknown'].advice);
  });

  it('stay as last read, and are forgotten when a timer is connected, because it may be another', async () => {
    const { session } = await read();
    await press('Disconnect');
    expect([session.knowledge.of(2).state, session.standing.value.sure]).toEqual(['read', 'once']);
    expect(said('M3')).toContain('DT 4:00 min');
    await press('Connect');
    expect(session.knowledge.of(2).state).toBe('unread');
  });

  it('are not shown before a timer was read', async () => {
    await opened();
    await goTo('memories');
    expect(screen.queryByRole('article')).toBeNull();
    expect(screen.getByRole('heading', { name: 'Backups' })).toBeTruthy();
  });
});

it('are compared on the page of comparisons, with the one that flies next, once both were read', async () => {
  await atMemories();
  expect(screen.queryByRole('button', { name: /^Compare with/ })).toBeNull();
  cleanup();
  await read();
  await press(`${en.overview.compareWith({ memory: 'M1' })}: M3`);
  expect(screen.getByRole('heading', { name: en.compare.title })).toBe(document.activeElement);
  const chosen = screen
    .getAllByRole<HTMLSelectElement>('combobox')
    .map(({ selectedOptions }) => selectedOptions[0]?.text);
  expect(chosen).toEqual([expect.stringContaining('M3'), expect.stringContaining('M1')]);
  expect(screen.getByText(en.overview.differs({ count: 1 }))).toBeTruthy();
});

it('keeps the focus when a backup is deleted, and when that is undone', async () => {
  await read();
  const press = (name: string | RegExp): void =>
    void act(() => {
      button(name).focus();
      button(name).click();
    });
  press(/^Delete: M1/);
  expect(document.activeElement?.textContent).toBe('Backups');
  press('Undo');
  expect(document.activeElement?.localName).toBe('main');
});
