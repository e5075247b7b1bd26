import { act, fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import type { View } from '../../../src/app/shell/views.js';
import { HOLD } from '../../../src/app/ui/press-and-hold.js';
import { en } from '../../tools/en.js';
import { connected, late, press as pressed, type as typed } from '../screen.js';
import { type AppBench, type BenchOptions, idle } from './bench.js';

let app: AppBench;

/** The bench has a view of its own; what is said beside the program stands in the other. */
function show(view: View): void {
  act(() => app.models.views.show(view));
}

/** A button, in whichever of the two views it stands. */
async function press(name: string | RegExp): Promise<void> {
  if (!screen.queryByRole('button', { name })) show(app.models.views.shown.value === 'bench' ? 'program' : 'bench');
  await pressed(name);
}

/** The whole screen with the bench open, and the pilot's word that it is safe. */
async function opened(options: BenchOptions = {}): Promise<AppBench> {
  app = await connected(options);
  show('bench');
  fireEvent.click(within(panel()).getByRole('checkbox', { name: /propeller is off/ }));
  await idle(0);
  app.timer.core.answered.length = 0;
  return app;
}

function panel(): HTMLElement {
  return document.querySelector('.bench') as HTMLElement;
}

function unlockButton(): HTMLElement {
  return within(panel()).getByRole('button', { name: /UNLOCK|Keep holding/ });
}

function unlocks({ timer }: AppBench): number {
  return timer.core.answered.filter(({ name }) => name === 'UNLOCK').length;
}

async function type(name: string, text: string): Promise<void> {
  show('program');
  await typed(name, text);
}

async function flip(): Promise<void> {
  show('bench');
  fireEvent.click(screen.getByRole('switch', { name: en.bench.follow }));
  await idle();
}

function isOn(): boolean {
  show('bench');
  const it = screen.getByRole('switch', { name: en.bench.follow });
  return it.getAttribute('aria-checked') === 'true';
}

describe('the bench', () => {
  it('moves the servos to a function, says so, and steps to the next and the previous one', async () => {
    const { timer } = await opened();
    await press('Function 4');
    expect(screen.getByText('Servos at function 4')).toBeTruthy();
    await press(en.next);
    expect([timer.core.slot, screen.queryByText('Servos at function 5') !== null]).toEqual([5, true]);
    await press(en.previous);
    await press(en.previous);
    expect(screen.getByText('Servos at function 3')).toBeTruthy();
    await press('DT');
    expect(screen.getByText('Servos at DT')).toBeTruthy();
  });

  it('has no motor to unlock on B', async () => {
    await opened({ identity: { timerClass: 'B' } });
    expect(within(panel()).queryByRole('button', { name: /UNLOCK/ })).toBeNull();
  });

  it('asks once more before the jump', async () => {
    const { timer, models } = await opened();
    expect(screen.queryByRole('button', { name: 'Jump…' }), 'the jump is shown only with Expert on').toBeNull();
    models.views.setExpert(true);
    await idle(0);
    const jumps = () => timer.core.answered.filter(({ name }) => name === 'JUMP2').length;
    await press('Jump…');
    await press('Cancel');
    const first = screen.getByRole('button', { name: 'Jump…' });
    await press('Jump…');
    expect([jumps(), first.isConnected], 'a held key must not press it again').toEqual([0, false]);
    await press(en.bench.jumpSure);
    expect([jumps(), screen.queryByText(en.bench.jumped) !== null]).toEqual([1, true]);
  });
});

describe('the grid of the bench', () => {
  const row = (name: string): HTMLElement => screen.getByRole('row', { name: new RegExp(`^${name}`) });
  const cells = (name: string): string[] => [...row(name).children].map(({ textContent }) => textContent?.trim() ?? '');

  it('shows what the timer holds, with the row where the servos stand', async () => {
    await opened();
    expect(cells('Function 4')).toEqual(['Function 4', '12.0 s', '55', '55', '55']);
    await press('Function 4');
    expect(row('Function 4').className).toContain('here');
    expect([...document.querySelectorAll('.bench-table .here')]).toHaveLength(1);
    await press(en.next);
    expect(['Function 4', 'Function 5'].map((name) => row(name).classList.contains('here'))).toEqual([false, true]);
  });

  it('shows positions that are not in the timer yet, to which the servos will not go', async () => {
    await opened();
    await type('Function 4, S2', '70');
    show('bench');
    expect(cells('Function 4')).toEqual(['Function 4', '12.0 s', '55', '55 70', '55']);
  });
});

describe('hold to unlock', () => {
  type Does = (button: HTMLElement) => void;
  const point = { button: 0, isPrimary: true };
  const down: Does = (button) => fireEvent.pointerDown(button, { ...point, buttons: 1 });
  const keyDown =
    (key: string): Does =>
    (button) =>
      fireEvent.keyDown(button, { key });
  const keyUp =
    (key: string): Does =>
    (button) =>
      fireEvent.keyUp(button, { key });
  const ways: [string, Does, Does][] = [
    ['a pointer', down, (button) => fireEvent.pointerUp(button)],
    ['a pointer that leaves', down, (button) => fireEvent.pointerLeave(button)],
    [
      'a mouse whose other button stays down',
      down,
      (button) => fireEvent.pointerMove(button, { ...point, buttons: 2 }),
    ],
    ['Space', keyDown(' '), keyUp(' ')],
    ['Enter', keyDown('Enter'), keyUp('Enter')],
    ['a key, and the focus goes', keyDown(' '), (button) => fireEvent.blur(button)],
  ];

  it.each(ways)('by %s: acts once for a whole hold, and not for a shorter one', async (_, down, up) => {
    const app = await opened();
    down(unlockButton());
    await vi.advanceTimersByTimeAsync(HOLD - 100);
    expect(unlockButton().textContent).toBe(en.bench.unlockHold);
    up(unlockButton());
    await idle();
    expect(unlocks(app)).toBe(0);
    down(unlockButton());
    await vi.advanceTimersByTimeAsync(HOLD);
    // A key that is still down repeats itself.
    down(unlockButton());
    await idle();
    expect(unlocks(app)).toBe(1);
    expect(screen.getByText(en.bench.unlocked)).toBeTruthy();
  });

  it('goes on while the finger moves on the button', async () => {
    const app = await opened();
    fireEvent.pointerDown(unlockButton(), { button: 0, buttons: 1, isPrimary: true });
    fireEvent.pointerMove(unlockButton(), { button: -1, buttons: 1, isPrimary: true });
    await vi.advanceTimersByTimeAsync(HOLD);
    await idle();
    expect(unlocks(app)).toBe(1);
  });

  it('does nothing on a click', async () => {
    const app = await opened();
    await press(en.bench.unlock);
    expect(unlocks(app)).toBe(0);
  });
});

it('an idle throttle waits for Write once it is changed', async () => {
  const { editor } = await opened();
  const waits = () => within(panel()).queryByText(en.bench.waits);
  expect(waits()).toBeNull();
  await press(en.of({ button: '+1', name: 'Idle throttle' }));
  expect([editor.changes.value, waits()]).toMatchObject([[{ field: { kind: 'idleThrottle' }, to: 31 }], {}]);
});

describe('servos that follow', () => {
  const row = (name: string): HTMLElement => {
    show('program');
    return screen.getByRole('row', { name: new RegExp(`^${name}`) });
  };
  const isMarked = (name: string): boolean => within(row(name)).queryByText('servos here') !== null;
  const band = (): string => document.querySelector('.top .unfinished')?.textContent ?? '';
  const note = (): string => {
    show('program');
    return [...document.querySelectorAll('.actions, .changes')].map(({ textContent }) => textContent).join(' ');
  };
  const positions = ({ timer }: AppBench): [stored: number | undefined, servo: number | undefined] => [
    timer.core.content.positions[1]?.[4],
    timer.core.servos[1],
  ];

  it('move with the field, and what was tried is kept', async () => {
    const app = await opened();
    await press('Function 4');
    await flip();
    expect(isOn()).toBe(true);
    expect([isMarked('Function 4'), isMarked('Function 5')]).toEqual([true, false]);
    await type('Function 4, S2', '70');
    expect(positions(app)).toEqual([70, 70]);
    show('bench');
    expect(screen.getByText(en.bench.triedHere({ named: 'Function 4, S2: 55 → 70', more: 0 }))).toBeTruthy();
    await press(en.bench.stopFollowing);
    expect([isOn(), isMarked('Function 4'), note().includes(en.bench.ended.over)]).toEqual([false, false, false]);
    expect(band()).toContain('Tried: Function 4, S2: 55 → 70. Keep what was tried');
    await press('Keep it');
    expect(screen.queryByRole('button', { name: 'Keep it' })).toBeNull();
    expect(positions(app)[0]).toBe(70);
  });

  it('are compared with what the timer held before, until that is decided', async () => {
    const behind = () => document.querySelector('.timeline-behind')?.textContent;
    await opened();
    await press('Function 4');
    await flip();
    show('program');
    await late();
    expect(behind()).toBeUndefined();
    await type('Function 4, S2', '70');
    expect(behind()).toBe(en.timeline.compareBefore);
    await press(en.bench.stopFollowing);
    expect(behind()).toBe(en.timeline.compareBefore);
    await press('Keep it');
    await late();
    expect(behind()).toBeUndefined();
  });

  it('name up to three positions that were tried', async () => {
    await opened();
    await press('Function 4');
    await flip();
    for (const servo of ['S1', 'S2', 'S3']) await type(`Function 4, ${servo}`, '71');
    await press('Function 5');
    await type('Function 5, S1', '72');
    await press(en.bench.stopFollowing);
    expect(band()).toMatch(
      /Tried: Function 4, S1: \d+ → 71; Function 5, S1: \d+ → 72; Function 4, S2: \d+ → 71; and 1 more position\./,
    );
  });

  it('are put back alone: what else was changed goes on waiting', async () => {
    const app = await opened();
    const { positions } = structuredClone(app.timer.core.content);
    await type('Idle throttle', '33');
    await type('Function 5, S1', '9');
    await press('Function 4');
    await flip();
    await type('Function 4, S2', '70');
    await flip();
    await press(en.bench.putBack);
    const dialog = within(screen.getByRole('dialog', { name: en.write.title }));
    expect(dialog.queryByRole('group', { name: en.write.target }), 'it belongs to this memory').toBeNull();
    fireEvent.click(dialog.getByRole('button', { name: 'Write 1 change' }));
    await idle();
    expect(dialog.getByRole('alert').textContent).toContain('Verified.');
    expect([app.timer.core.content.positions, app.timer.core.idleThrottle]).toEqual([positions, 30]);
    expect(app.editor.changes.value.map(({ to }) => to)).toEqual([9, 33]);
    expect(screen.queryByRole('button', { name: 'Keep it' })).toBeNull();
  });

  it('can be sent to the edited function by a button under its row', async () => {
    const app = await opened();
    await flip();
    expect(note()).toContain(en.bench.atNone);
    await type('Function 4, S2', '70');
    expect(positions(app)).toEqual([55, 115]);
    const offer = screen.getByRole('button', { name: 'Move the servos to function 4' });
    expect(offer.closest('tr')?.previousElementSibling).toBe(row('Function 4'));
    expect(offer.closest('tr')?.textContent).toContain(en.bench.waits);
    await press('Move the servos to function 4');
    expect([positions(app), isMarked('Function 4')]).toEqual([[70, 70], true]);
    expect(screen.queryByRole('button', { name: /^Move the servos/ })).toBeNull();
    expect(document.activeElement?.getAttribute('aria-label')).toBe('Function 4, S2');
    expect(note()).toContain('Servos at function 4');
    await type('Function 5, S2', '7');
    expect(screen.getByRole('button', { name: 'Move the servos to function 5' }).closest('tr')?.textContent).toContain(
      'Servos at function 4',
    );
  });

  it('say why they have stopped, and what may have moved', async () => {
    const { timer } = await opened();
    await press('Function 4');
    await flip();
    await press('Read again');
    expect(note()).toContain(en.bench.ended.over);
    await press('Dismiss');
    expect(note()).not.toContain(en.bench.ended.over);
    await flip();
    // After the reading that follows the first position.
    timer.core.onAnswer = ({ name }) => name === 'GETSWVER' && timer.core.sleep();
    await type('Function 4, S2', '70');
    expect(note()).toContain(en.bench.ended.failed);
    expect(note()).toContain(en.bench.moveMaybe);
  });

  it('a timer that keeps no position: says so with values, and leaves what was typed as a change', async () => {
    const { editor } = await opened({ quirks: { servoIgnored: true } });
    await press('Function 4');
    await flip();
    const held = String(editor.working.value?.positions[1]?.[4]);
    await type('Function 4, S2', '70');
    expect(note()).toContain(
      `${en.bench.ended.unlike} ${en.bench.notTaken({ field: 'Function 4, S2', wanted: '70', held })}`,
    );
    expect(editor.changes.value).toMatchObject([{ from: Number(held), to: 70 }]);
    expect(screen.queryByRole('button', { name: en.bench.putBack })).toBeNull();
  });

  it('a timer that takes the servo first: names the value that changed beside, and offers to put it back', async () => {
    const { timer, editor } = await opened({ quirks: { servoFirst: true } });
    await press('Function 2');
    await flip();
    const [held, , beside] =
      editor.working.value?.positions.map((row, servo) => String(row[servo === 0 ? 2 : 0])) ?? [];
    await type('Function 2, S1', '70');
    expect(note()).toContain(en.bench.notTaken({ field: 'Function 2, S1', wanted: '70', held: held ?? '' }));
    expect(note()).toContain(en.bench.beside({ named: `Start, S3: ${beside} → 70`, more: 0 }));
    expect(editor.changes.value.map(({ from, to }) => [from, to])).toEqual([[Number(held), 70]]);
    await press(en.bench.putBack);
    expect(editor.working.value?.positions[2]?.[0]).toBe(Number(beside));
    expect(timer.core.content.positions[2]?.[0]).toBe(70);
  });
});
