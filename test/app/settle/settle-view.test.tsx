import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import * as files from '../../../src/app/browser/save-file.js';
import { HOLD } from '../../../src/app/ui/press-and-hold.js';
import { en } from '../../tools/en.js';
import { type AppBench, type BenchOptions, idle } from '../bench/bench.js';
import { button, connected, goTo, opened, press } from '../screen.js';

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
  fireEvent.click(screen.getByRole('checkbox', { name: en.settle.safe }));
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
  await press(en.settle.readIt);
  await press(RIGHT);
  await press(en.settle.yes);
  await press('M1');
  await press(en.settle.ask);
}

describe('the walk', () => {
  it('is offered where the timer is told about, and leads back there', async () => {
    await connected();
    await goTo('settings');
    expect(screen.getByRole('link', { name: en.settle.title }).getAttribute('href')).toBe('#settings/settle');
  });

  it('asks first that no propeller can turn, and says so at each step that moves something', async () => {
    const { timer, session } = await begun();
    expect(button(en.settle.readIt).disabled).toBe(true);
    await read();
    expect(step()).toBe(`6 / 9 · ${en.settle.tryIt}`);
    expect(document.activeElement?.textContent, 'the focus goes with the step').toBe(step());
    expect(screen.getByText(en.settle.danger)).toBeTruthy();
    expect(button(en.settle.tryIt).disabled, 'before the servos were moved away').toBe(true);
    await press('Move the servos to DT');
    expect(timer.core.slot).toBe(10);
    await press(en.settle.tryIt);
    await press(en.settle.no);
    expect([step(), screen.getAllByText(en.settle.danger).length]).toEqual([`7 / 9 · ${en.settle.tryIt}`, 1]);
    await press('Move the servos to function 1');
    await press(en.settle.tryIt);
    await press(en.settle.yes);
    expect(screen.getByText(en.settle.danger)).toBeTruthy();
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
    expect(answerOf(en.settle.names.moves)).toBe(en.settle.there);
    expect(answerOf(en.settle.names.unlock)).toBe('6E');
    expect(answerOf(en.settle.names.memories)).toBe(en.settle.yes);
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
    await press(en.settle.readIt);
    await press(en.settle.unknown);
    expect([step(), answerOf(en.settle.names.order)]).toEqual([`3 / 9 · ${en.settle.names.count}?`, en.settle.open]);
    await press(en.previous);
    await press(RIGHT);
    expect([answerOf(en.settle.names.order), answerOf(en.settle.names.unit)]).toEqual([en.settle.no, en.settle.yes]);
    await press(en.previous);
    expect(button(RIGHT).getAttribute('aria-pressed')).toBe('true');
    await press(en.settle.unknown);
    expect(answerOf(en.settle.names.order)).toBe(en.settle.open);
  });

  it('has no motor to unlock on B, and no step for what a timer cannot show', async () => {
    await begun({ identity: { timerClass: 'B' } });
    await tick();
    await press(en.settle.readIt);
    expect(step()).toMatch(/^2 \/ 8/);
    for (let i = 0; i < 6; i++) await press(en.next);
    expect([step(), answerOf(en.settle.names.reserved), has(en.bench.unlock)]).toEqual([
      `8 / 8 · ${en.done}`,
      '0',
      false,
    ]);
  });

  it('offers to connect without a timer', async () => {
    const app = await opened();
    await toWalk(app);
    expect([screen.queryByRole('checkbox', { name: en.settle.safe }), button(en.settle.readIt).disabled]).toEqual([
      null,
      true,
    ]);
    await press('Connect');
    expect(screen.getByRole('checkbox', { name: en.settle.safe })).toBeTruthy();
  });

  it('says that something else is to be settled first', async () => {
    const { session, editor } = await begun();
    const held = editor.baseline.value as NonNullable<typeof editor.baseline.value>;
    expect(screen.queryByText(en.settle.blocked)).toBeNull();
    await session.knowledge.begin(held, held);
    session.knowledge.jobOver();
    await idle(0);
    expect(screen.getByText(en.settle.blocked)).toBeTruthy();
  });
});

describe('what is settled', () => {
  it('stands under “About this timer”, also after a reload, and in a file without a name', async () => {
    const saved: [string, string][] = [];
    vi.spyOn(files, 'saveFile').mockImplementation((name, text) => void saved.push([name, text]));
    const app = await begun({ quirks: { servoFirst: true } });
    await read();
    await press('Move the servos to DT');
    await press(en.settle.tryIt);
    await press(en.settle.no);
    for (let i = 0; i < 2; i++) await press(en.next);
    await press(en.save);
    const [[name, text] = ['', '']] = saved;
    expect(name).toBe('sidus-settled-Q536.txt');
    expect(text).toMatch(/^# Sidus capture 1\n/);
    expect(text).toContain(
      `# ${en.settle.names.layout}: ${en.settle.no}\n# ${en.settle.names.stores}: ${en.settle.yes}\n`,
    );
    expect(text).toContain(`# ${en.settle.names.unlock}: ${en.settle.open}\n`);
    expect(text).toContain('issues/new?template=capture.yml');
    expect(text).toContain('> 00 00 00 00 03 6b 6b 45');
    app.models.views.show('settings');
    await idle(0);
    expect(screen.getByText(`${en.settle.names.layout}: ${en.settle.no}`)).toBeTruthy();
    expect(screen.queryByText(new RegExp(en.settle.names.unlock))).toBeNull();
    expect(has(en.aboutTimer.forget), 'four zeros were only tried').toBe(false);
  });
});
