import { fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import * as files from '../../../src/app/browser/save-file.js';
import { en } from '../../../src/app/messages/en.js';
import { settle as words } from '../../../src/app/messages/en-settle.js';
import { HOLD } from '../../../src/app/ui/press-and-hold.js';
import { type AppBench, type BenchOptions, idle } from '../bench/bench.js';
import { button, connected, goTo, opened, press } from '../screen.js';

beforeEach(() => localStorage.clear());
afterEach(() => void vi.restoreAllMocks());

/** What the handheld of the virtual timer shows. */
const RIGHT = /^Function\s5\s12\.50\ss\s·\sDT\s3:00/;

async function begun(options: BenchOptions = {}): Promise<AppBench> {
  const app = await connected(options);
  await toWalk(app);
  return app;
}

async function toWalk({ models }: AppBench): Promise<void> {
  await goTo('settings');
  models.views.show('settings', 'settle');
  await idle(0);
}

async function tick(): Promise<void> {
  fireEvent.click(screen.getByRole('checkbox', { name: words.safe }));
  await idle(0);
}

const step = (): string => screen.getByRole('heading', { level: 2, name: /^\d+ \/ \d+/ }).textContent ?? '';
const has = (name: string): boolean => screen.queryByRole('button', { name }) !== null;
const answerOf = (name: string): string | undefined =>
  within(document.querySelector('.settle-list') as HTMLElement).getByText(name).nextElementSibling?.textContent ??
  undefined;

/** The first steps, which only read. */
async function read(): Promise<void> {
  await tick();
  await press(words.readIt);
  await press(RIGHT);
  await press(words.yes);
  await press('M1');
  await press(words.ask);
}

describe('the walk', () => {
  it('is offered where the timer is told about, and leads back there', async () => {
    await connected();
    await goTo('settings');
    expect(screen.getByRole('link', { name: words.title }).getAttribute('href')).toBe('#settings/settle');
  });

  it('asks first that no propeller can turn, and says so at each step that moves something', async () => {
    const { timer, session } = await begun();
    expect(button(words.readIt).disabled).toBe(true);
    await read();
    expect(step()).toBe(`6 / 9 · ${words.tryIt}`);
    expect(document.activeElement?.textContent, 'the focus goes with the step').toBe(step());
    expect(screen.getByText(words.danger)).toBeTruthy();
    expect(button(words.tryIt).disabled, 'before the servos were moved away').toBe(true);
    await press('Move the servos to DT');
    expect(timer.core.slot).toBe(10);
    await press(words.tryIt);
    await press(words.no);
    expect([step(), screen.getAllByText(words.danger).length]).toEqual([`7 / 9 · ${words.tryIt}`, 1]);
    await press('Move the servos to function 1');
    await press(words.tryIt);
    await press(words.yes);
    expect(screen.getByText(words.danger)).toBeTruthy();
    expect(screen.getByText(en.bench.unlockHint)).toBeTruthy();
    expect(timer.core.motorLocked).toBe(true);
    session.safety.withdraw();
    await idle(0);
    expect(button(en.bench.unlock).disabled).toBe(true);
    await tick();
    fireEvent.pointerDown(button(en.bench.unlock), { button: 0, isPrimary: true });
    await vi.advanceTimersByTimeAsync(HOLD);
    await idle();
    expect([timer.core.motorLocked, step()]).toEqual([false, `9 / 9 · ${en.done}`]);
    expect(screen.getByText(en.bench.unlocked)).toBeTruthy();
    expect(answerOf(words.names.moves)).toBe(words.there);
    expect(answerOf(words.names.unlock)).toBe('6E');
    expect(answerOf(words.names.memories)).toBe(words.yes);
  });

  it('says that the motor may be unlocked when no answer came', async () => {
    const { timer } = await begun();
    await read();
    for (let i = 0; i < 2; i++) await press(en.next);
    timer.core.onAnswer = ({ name }) => name === 'UNLOCK' && timer.core.sleep();
    timer.core.sleep();
    fireEvent.pointerDown(button(en.bench.unlock), { button: 0, isPrimary: true });
    await vi.advanceTimersByTimeAsync(HOLD);
    await idle();
    expect(screen.getByText(en.bench.unlockMaybe)).toBeTruthy();
  });

  it('settles nothing of what a person does not know, and goes back to an answer', async () => {
    await begun({ quirks: { bigEndianTimes: true } });
    await tick();
    await press(words.readIt);
    await press(words.unknown);
    expect([step(), answerOf(words.names.order)]).toEqual([`3 / 9 · ${words.names.count}?`, words.open]);
    await press(en.previous);
    await press(RIGHT);
    expect([answerOf(words.names.order), answerOf(words.names.unit)]).toEqual([words.no, words.yes]);
    await press(en.previous);
    expect(button(RIGHT).getAttribute('aria-pressed')).toBe('true');
    await press(words.unknown);
    expect(answerOf(words.names.order)).toBe(words.open);
  });

  it('has no motor to unlock on B, and no step for what a timer cannot show', async () => {
    await begun({ identity: { timerClass: 'B' } });
    await tick();
    await press(words.readIt);
    expect(step()).toMatch(/^2 \/ 8/);
    for (let i = 0; i < 6; i++) await press(en.next);
    expect([step(), answerOf(words.names.reserved), has(en.bench.unlock)]).toEqual([`8 / 8 · ${en.done}`, '0', false]);
  });

  it('offers to connect without a timer', async () => {
    const app = await opened();
    await toWalk(app);
    expect([screen.queryByRole('checkbox', { name: words.safe }), button(words.readIt).disabled]).toEqual([null, true]);
    await press('Connect');
    expect(screen.getByRole('checkbox', { name: words.safe })).toBeTruthy();
  });

  it('says that something else is to be settled first', async () => {
    const { session, editor } = await begun();
    const held = editor.baseline.value as NonNullable<typeof editor.baseline.value>;
    expect(screen.queryByText(words.blocked)).toBeNull();
    await session.knowledge.begin(held, held);
    session.knowledge.jobOver();
    await idle(0);
    expect(screen.getByText(words.blocked)).toBeTruthy();
  });
});

describe('what is settled', () => {
  it('stands under “About this timer”, also after a reload, and in a file without a name', async () => {
    const saved: [string, string][] = [];
    vi.spyOn(files, 'saveFile').mockImplementation((name, text) => void saved.push([name, text]));
    const app = await begun({ quirks: { servoFirst: true } });
    await read();
    await press('Move the servos to DT');
    await press(words.tryIt);
    await press(words.no);
    for (let i = 0; i < 2; i++) await press(en.next);
    await press(en.save);
    const [[name, text] = ['', '']] = saved;
    expect(name).toBe('sidus-settled-Q536.txt');
    expect(text).toMatch(/^# Sidus capture 1\n/);
    expect(text).toContain(`# ${words.names.layout}: ${words.no}\n# ${words.names.stores}: ${words.yes}\n`);
    expect(text).toContain(`# ${words.names.unlock}: ${words.open}\n`);
    expect(text).toContain('issues/new?template=capture.yml');
    expect(text).toContain('> 00 00 00 00 03 6b 6b 45');
    app.models.views.show('settings');
    await idle(0);
    expect(screen.getByText(`${words.names.layout}: ${words.no}`)).toBeTruthy();
    expect(screen.queryByText(new RegExp(words.names.unlock))).toBeNull();
    expect(has(en.aboutTimer.forget), 'four zeros were only tried').toBe(false);
  });
});
