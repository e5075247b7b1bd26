import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { SHAPES } from '../../../src/app/ui/shapes.js';
import { en } from '../../tools/en.js';
import { connected, goTo, inWindow, press } from '../screen.js';
import { type AppBench, type BenchOptions, idle } from './bench.js';

/** The bench with the servos at function 4, whose positions are all 55. */
async function atFour(options: BenchOptions = {}): Promise<AppBench> {
  const app = await connected(options);
  await goTo('bench');
  fireEvent.click(screen.getByRole('checkbox', { name: /propeller is off/ }));
  await idle(0);
  await press('Function 4');
  return app;
}

async function flip(): Promise<void> {
  fireEvent.click(screen.getByRole('switch', { name: en.bench.follow }));
  await idle();
}

const trim = (name: string): HTMLElement => screen.getByRole('group', { name });
const field = (servo: string): HTMLInputElement =>
  within(trim(`Function 4, ${servo}`)).getByRole<HTMLInputElement>('textbox');
const key = (step: string, servo = 'S2'): HTMLElement =>
  screen.getByRole('button', { name: en.of({ button: step, name: `Function 4, ${servo}` }) });
const stored = ({ timer }: AppBench): [stored: number | undefined, servo: number | undefined] => [
  timer.core.content.positions[1]?.[4],
  timer.core.servos[1],
];
const was = (servo: string): string | undefined =>
  trim(`Function 4, ${servo}`).querySelector('.trim-was')?.textContent ?? undefined;

function type(text: string): void {
  field('S2').focus();
  fireEvent.input(field('S2'), { target: { value: text } });
}

/** Ways to hold a key, and to release it. */
const HOLDS: [string, (on: HTMLElement) => void, (on: HTMLElement) => void][] = [
  [
    'a mouse',
    (on) => fireEvent.pointerDown(on, { button: 0, buttons: 1, isPrimary: true }),
    (on) => [fireEvent.pointerUp(on), fireEvent.click(on)],
  ],
  ...[' ', 'Enter'].map((name): (typeof HOLDS)[number] => [
    name === ' ' ? 'Space' : name,
    (on) => [fireEvent.keyDown(on, { key: name }), fireEvent.keyDown(on, { key: name, repeat: true })],
    (on) => fireEvent.keyUp(on, { key: name }),
  ]),
];

describe('trimming', () => {
  it('is offered where the servos stand, by one and by ten, and waits for Write', async () => {
    const app = await connected();
    await goTo('bench');
    expect(document.querySelector('.bench-trim')).toBeNull();
    fireEvent.click(screen.getByRole('checkbox', { name: /propeller is off/ }));
    await idle(0);
    await press('Function 4');
    const values: string[] = [];
    for (const step of ['+1', '+10', '−1', '−10', '−10']) {
      fireEvent.click(key(step));
      values.push(field('S2').value);
    }
    expect([values, stored(app)]).toEqual([
      ['56', '66', '65', '55', '45'],
      [55, 55],
    ]);
    expect([was('S2'), was('S1')]).toEqual(['was 55', undefined]);
    expect(within(document.querySelector('.bench-trim') as HTMLElement).getByText(en.bench.waits)).toBeTruthy();
  });

  it('takes a typed position, and moves the servo once it is typed', async () => {
    const app = await atFour();
    await flip();
    type('7');
    await idle(100);
    type('72');
    await idle(100);
    expect(stored(app)).toEqual([55, 55]);
    fireEvent.keyDown(field('S2'), { key: 'Enter' });
    await idle();
    expect([stored(app), was('S2')]).toEqual([[72, 72], 'was 55']);
    expect(app.timer.core.answered.filter(({ name }) => name === 'SETSERVO')).toHaveLength(1);
    app.editor.undo();
    await idle();
    expect([stored(app), field('S2').value, was('S2')]).toEqual([[55, 55], '55', undefined]);
  });

  it.each([
    ['140', en.findings['position-out-of-range']({ min: '0', max: '130' })],
    ['up', en.unreadable['not-a-whole-number']],
  ])('refuses “%s” with the reason, and sends nothing', async (text, reason) => {
    const app = await atFour();
    await flip();
    type(text);
    field('S2').blur();
    await idle();
    expect(within(trim('Function 4, S2')).getByRole('alert').textContent).toBe(reason);
    expect([field('S2').getAttribute('aria-invalid'), stored(app)]).toEqual(['true', [55, 55]]);
    fireEvent.keyDown(field('S2'), { key: 'Escape' });
  });

  it.each(HOLDS)('steps once for a short press by %s, and on while it is held, as one step to undo', async (...way) => {
    const [, down, up] = way;
    const { editor } = await atFour();
    down(key('+1'));
    await idle(400);
    expect(field('S2').value).toBe('55');
    up(key('+1'));
    expect(field('S2').value).toBe('56');
    down(key('+1'));
    await idle(450 + 3 * 90);
    up(key('+1'));
    await idle();
    expect(field('S2').value).toBe('60');
    editor.undo();
    await idle(0);
    expect(field('S2').value).toBe('56');
    editor.undo();
    await idle(0);
    expect(field('S2').value).toBe('55');
  });

  it('stops when the focus goes, and hears no key that went down elsewhere', async () => {
    await atFour();
    fireEvent.keyUp(key('+1'), { key: 'Enter' });
    fireEvent.keyDown(key('+1'), { key: 'Enter', repeat: true });
    await idle();
    expect(field('S2').value).toBe('55');
    fireEvent.keyDown(key('+1'), { key: ' ' });
    await idle(450);
    fireEvent.blur(key('+1'));
    await idle();
    expect(field('S2').value).toBe('56');
  });

  it('moves the servo with a key that is held while they follow, until the timer answers no more', async () => {
    const app = await atFour({ latency: 100 });
    await flip();
    fireEvent.pointerDown(key('+1'), { button: 0, buttons: 1, isPrimary: true });
    await idle(5000);
    app.timer.core.sleep();
    await idle();
    const [, servo = 0] = stored(app);
    expect(servo).toBeGreaterThan(60);
    expect(screen.queryByRole('group', { name: 'Function 4, S2' })).toBeNull();
    expect(app.editor.working.value?.positions[1]?.[4]).toBeLessThanOrEqual(servo + 1);
    expect(app.follow.ended.value?.reason).toBe('failed');
  });

  it('says what the timer held before the servos followed, until that is decided', async () => {
    const app = await atFour();
    await flip();
    fireEvent.click(key('−10'));
    await idle();
    fireEvent.click(key('−1'));
    await idle();
    expect([stored(app), was('S2'), was('S1')]).toEqual([[44, 44], 'was 55', undefined]);
    await flip();
    expect(was('S2')).toBe('was 55');
    // Back to what it held: that is a change of what it holds now.
    fireEvent.click(key('+1'));
    fireEvent.click(key('+10'));
    await idle();
    expect([field('S2').value, was('S2')]).toEqual(['55', 'was 44']);
    app.editor.revertAll();
    await press('Keep it');
    expect([field('S2').value, was('S2')]).toEqual(['44', undefined]);
  });
});

it('on a phone the pilot chooses one servo, and sees where each of them stands', async () => {
  inWindow((query) => query === SHAPES.phone);
  await atFour();
  const title = en.bench.trim({ slot: 'function 4' });
  const choice = within(screen.getByRole('group', { name: title }));
  expect(choice.getAllByRole('radio').map((radio) => radio.closest('label')?.textContent)).toEqual([
    'S1 55',
    'S2 55',
    'S3 55',
  ]);
  expect(screen.queryByRole('group', { name: 'Function 4, S2' })).toBeNull();
  fireEvent.click(choice.getByRole('radio', { name: 'S2 55' }));
  await idle(0);
  fireEvent.click(key('+10'));
  await idle(0);
  expect([field('S2').value, choice.getByRole<HTMLInputElement>('radio', { name: 'S2 65' }).checked]).toEqual([
    '65',
    true,
  ]);
  await press(en.next);
  expect(screen.getByRole('group', { name: 'Function 5, S2' })).toBeTruthy();
});

describe('the names that the pilot gave the servos', () => {
  it('stand on the bench and in the heads of the table', async () => {
    const app = await atFour();
    const use = { low: 0, high: 130, reversed: false };
    app.session.servoUses.say([
      { ...use, duty: 'tailplane', name: 'Руль высоты' },
      { ...use, duty: 'rudder', name: '' },
      { ...use, duty: 'none', name: '' },
    ]);
    await idle(0);
    const names = ['Руль высоты', 'Rudder', 'Not used'];
    for (const [servo, name] of names.entries()) {
      expect(trim(`Function 4, S${servo + 1} ${name}`).textContent).toContain(`S${servo + 1} ${name}`);
    }
    const heads = () => screen.getAllByRole('columnheader').slice(-3);
    expect(heads().map(({ textContent }) => textContent)).toEqual(names.map((name, servo) => `S${servo + 1} ${name}`));
    await goTo('program');
    for (const [servo, name] of names.entries()) {
      const head = screen.getByRole('columnheader', { name: `S${servo + 1} ${name}` });
      expect(head.textContent).toBe(`S${servo + 1}${name}`);
      expect(within(head).getByRole('button').title).toBe(en.edits.table.tools({ name: `S${servo + 1} ${name}` }));
    }
    app.session.servoUses.say(null);
    await idle(0);
    expect(screen.getByRole('columnheader', { name: 'S1' }).textContent).toBe('S1');
  });
});
