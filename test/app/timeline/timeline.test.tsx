import { signal } from '@preact/signals';
import { act, fireEvent, render, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import type { OnEdit } from '../../../src/app/timeline/drag.js';
import { Timeline, type TimelineProps } from '../../../src/app/timeline/timeline.js';
import { TimelineModel } from '../../../src/app/timeline/view-model.js';
import { type ProgramField, type TimerProgram, withValue } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { programOf } from '../programs.js';

/**
 * Every call of onEdit in one line: the value, a full stop after the last one of a movement, and whether it led back.
 */
type Log = string[];

const PROGRAM = programOf('Q', [1000, 200, 400, 600, 18000]);

/** A timeline whose program changes as it says. */
function shown(program: TimerProgram = PROGRAM, props: Partial<TimelineProps> = {}) {
  const current = signal(program);
  const selected = signal<ProgramField | null>(null);
  const log: Log = [];
  const onEdit: OnEdit = (edit, phase) => {
    for (const { field, value } of 'values' in edit ? edit.values : []) {
      current.value = withValue(current.value, field, value);
      log.push(`move-${field.kind} ${value}${{ moving: '', done: '.', back: ' back.' }[phase]}`);
    }
  };
  const Bench = () => (
    <Timeline
      program={current.value}
      now={() => current.value}
      selected={selected.value}
      onEdit={onEdit}
      onSelect={(field) => {
        selected.value = field;
      }}
      {...props}
    />
  );
  const { unmount } = render(<Bench />);
  return { current, selected, log, unmount };
}

const handle = (name: string, exact = true): Element =>
  screen.getByRole('slider', { name: exact ? name : new RegExp(`^${name}`) });
const picture = (): HTMLElement => screen.getByRole('group', { name: /over time/ });

/** Where a handle is in the window. */
function placeOf(element: Element): { clientX: number; clientY: number } {
  const [, x, y] = /translate\((\S+) (\S+)\)/.exec(element.getAttribute('transform') ?? '') ?? [];
  const { left, top } = picture().getBoundingClientRect();
  return { clientX: left + Number(x), clientY: top + Number(y) };
}

/** Where the name of a servo stands, which lies in its lane. */
function heightOf(servo: string): number {
  const name = [...document.querySelectorAll('.lane-names [data-servo]')].find(
    ({ textContent }) => textContent === servo,
  );
  return picture().getBoundingClientRect().top + Number(name?.getAttribute('y'));
}

/** The servo whose lane has handles. */
const inHand = (): string | undefined => handle('Start, S', false).getAttribute('aria-label')?.slice(-2);

/** Clicks into the lane of a servo, at its left edge. */
async function choose(servo: string): Promise<void> {
  const { left } = picture().getBoundingClientRect();
  const at = { ...mouse, clientX: left + 10, clientY: heightOf(servo) };
  await act(() => void fireEvent.pointerDown(picture(), at));
  await act(() => void fireEvent.pointerUp(picture(), at));
}

/** The value of a field as its handle tells it: a position in steps, a time in hundredths of a second. */
const standing = (name: string): number =>
  Math.round(Number(handle(name).getAttribute('aria-valuenow')) * (name.endsWith('time') ? 100 : 1));

const mouse = { pointerId: 1, pointerType: 'mouse', button: 0, buttons: 1 };

/** Takes a handle with the mouse and moves it by so many pixels, without letting go. */
async function hold(name: string, dx: number, dy: number, more: object = {}): Promise<() => Promise<void>> {
  const start = placeOf(handle(name));
  const end = { ...mouse, ...more, clientX: start.clientX + dx, clientY: start.clientY + dy };
  await act(() => void fireEvent.pointerDown(handle(name), { ...mouse, ...start }));
  await act(() => void fireEvent.pointerMove(picture(), end));
  return () => act(() => void fireEvent.pointerUp(picture(), end));
}

/** Waits until the screen has drawn what the pointer has reported. */
async function drawn(): Promise<void> {
  await act(() => new Promise<void>((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve()))));
}

async function key(element: Element, pressed: string, more: object = {}): Promise<void> {
  await act(() => void fireEvent.keyDown(element, { key: pressed, ...more }));
  await act(() => void fireEvent.keyUp(element, { key: pressed, ...more }));
}

describe('the handles', () => {
  it('are sliders with the names of the fields, one for each time and one for each step of the servo in front', () => {
    shown();
    const names = screen.getAllByRole('slider').map((slider) => slider.getAttribute('aria-label'));
    expect(names).toEqual([
      en.program.motorStopTime,
      'Start, S1',
      'Function 1 time',
      'Function 1, S1',
      'Function 2 time',
      'Function 2, S1',
      'Function 3 time',
      'Function 3, S1',
      'DT time',
      'DT, S1',
    ]);
  });

  it('say their value and how far they can go', () => {
    shown();
    const told = (name: string) =>
      ['aria-valuemin', 'aria-valuenow', 'aria-valuemax', 'aria-valuetext'].map((a) => handle(name).getAttribute(a));
    expect(told('Function 2 time')).toEqual(['2.1', '4', '5.9', '4.00 s']);
    expect(told('DT time')).toEqual(['7', '180', '655', '3:00']);
    expect(told('Function 2, S1')).toEqual(['0', '12', '130', '12 steps']);
  });

  it('are those of the servo that is chosen, and of the one whose field is selected elsewhere', async () => {
    const { selected } = shown();
    await choose('S2');
    expect(handle('Function 2, S2').getAttribute('aria-valuenow')).toBe('22');
    await act(() => {
      selected.value = { kind: 'position', servo: 2, slot: 1 };
    });
    expect(handle('Function 2, S3').getAttribute('aria-valuenow')).toBe('32');
  });

  it('are not shown when nothing can be changed, and a reserved time never has one', () => {
    shown(programOf('B', [77, 200, 400, 600, 18000]), { onEdit: undefined });
    expect(screen.queryAllByRole('slider')).toEqual([]);
    shown(programOf('B', [77, 200, 400, 600, 18000]));
    expect(screen.queryByRole('slider', { name: 'Start time' })).toBeNull();
  });
});

describe('the lanes', () => {
  it('have the names that the pilot gives to what the servos move', () => {
    shown(PROGRAM, { names: ['rudder', '', 'wing'] });
    const names = [...document.querySelectorAll('.lane-names text')].map(({ textContent }) => textContent);
    expect(names, 'only the tall lane has room for its name').toEqual(['S1', 'rudder', 'S2', 'S3']);
  });

  it('can be visited by the keyboard, and a screen reader says them', async () => {
    shown();
    const said: (string | null)[] = [];
    for (const pressed of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowUp']) {
      await key(picture(), pressed);
      said.push(screen.getByRole('status').textContent);
    }
    expect(said).toEqual(['S2', 'S3', 'S3', 'S2']);
    expect(handle('Function 2, S2')).toBeTruthy();
  });
});

describe('the mouse', () => {
  it('moves a time in steps of the class, shows it meanwhile, and announces it on release', async () => {
    const { log, current } = shown();
    const release = await hold('Function 2 time', 12, 0);
    await drawn();
    expect(log).toHaveLength(1);
    expect(log[0]).toMatch(/^move-time 4[1-9]0$/);
    expect(screen.getByText('Function 2 time', { selector: '.timeline-readout span' })).toBeTruthy();
    await release();
    expect(log).toEqual([log[0], `${log[0]}.`]);
    expect(current.value.times[2]).toBe(Number(log[0]?.split(' ')[1]));
  });

  it('stops before the neighbour', async () => {
    const { log } = shown();
    await (await hold('Function 2 time', 5000, 0))();
    expect(log.at(-1)).toBe('move-time 590.');
    await (await hold('Function 2 time', -5000, 0))();
    expect(log.at(-1)).toBe('move-time 210.');
  });

  it('moves a position up and down, whole steps from 0 to 130', async () => {
    const { log } = shown();
    await (await hold('Function 2, S1', 0, -25))();
    expect(log.at(-1)).toMatch(/^move-position 3\d\.$/);
    await (await hold('Function 2, S1', 0, -5000))();
    expect(log.at(-1)).toBe('move-position 130.');
    await (await hold('Function 2, S1', 0, 5000))();
    expect(log.at(-1)).toBe('move-position 0.');
  });

  it('announces nothing on a click', async () => {
    const { log, selected } = shown();
    await (await hold('Function 2 time', 0, 0))();
    expect(log).toEqual([]);
    expect(selected.value).toEqual({ kind: 'time', slot: 2 });
    expect(document.activeElement).toBe(handle('Function 2 time'));
    expect(handle('DT time').getAttribute('tabindex'), 'the Tab key goes on among the handles').toBe('0');
  });

  it('puts back with Escape, and nothing moves after that', async () => {
    const { log, current } = shown();
    const release = await hold('Function 2, S1', 0, -40);
    await drawn();
    const seen: string[] = [];
    const outside = (event: KeyboardEvent): void => void seen.push(event.key);
    document.addEventListener('keydown', outside);
    await act(() => void fireEvent.keyDown(document.body, { key: 'Escape' }));
    document.removeEventListener('keydown', outside);
    expect(log.at(-1)).toBe('move-position 12 back.');
    expect(seen, 'this Escape does nothing else on the page').toEqual([]);
    await release();
    expect([log.at(-1), current.value.positions[0]?.[2]]).toEqual(['move-position 12 back.', 12]);
  });

  it.each([
    ['a mouse over another window', { buttons: 0 }],
    ['a mouse while another one is down', { buttons: 2 }],
    ['a pen that was lifted', { buttons: 0, pointerType: 'pen' }],
  ])('puts back when the button of %s was released where the page cannot hear it', async (_, moved) => {
    const { log, current } = shown();
    await hold('Function 2, S1', 0, -40);
    await drawn();
    expect(current.value.positions[0]?.[2]).not.toBe(12);
    // Now the mouse moves, without the button down that began it.
    const back = { ...placeOf(handle('Function 2, S1')), ...mouse, ...moved };
    await act(() => void fireEvent.pointerMove(picture(), { ...back, clientY: back.clientY - 80 }));
    await drawn();
    expect([log.at(-1), current.value.positions[0]?.[2]]).toEqual(['move-position 12 back.', 12]);
  });

  it('takes the line of the selected servo by any part, and of another lane only selects the servo', async () => {
    const { log } = shown();
    await choose('S3');
    const { clientX, clientY } = placeOf(handle('Function 3, S3'));
    const from = { ...mouse, clientX: clientX + 20, clientY };
    await act(() => void fireEvent.pointerDown(picture(), from));
    await act(() => void fireEvent.pointerUp(picture(), { ...from, clientY: clientY + 1000 }));
    expect(handle('Function 3, S3').getAttribute('aria-valuenow')).toBe('0');
    log.length = 0;
    const other = { ...mouse, clientX: clientX + 20, clientY: heightOf('S1') };
    await act(() => void fireEvent.pointerDown(picture(), other));
    await act(() => void fireEvent.pointerUp(picture(), other));
    expect([log, inHand()]).toEqual([[], 'S1']);
  });

  it('keeps the axis and the height of the picture while a handle is held, and no longer', async () => {
    shown();
    const style = () => (document.querySelector('.timeline-room') as HTMLElement).style;
    const before = placeOf(handle('Function 3, S1'));
    expect([style().flex, style().height]).toEqual(['', '']);
    const release = await hold('Function 2 time', 15, 0);
    await drawn();
    expect(placeOf(handle('Function 3, S1'))).toEqual(before);
    expect(style().height).toBe(`${picture().getAttribute('height')}px`);
    expect(style().flex).toMatch(/^(none|0 0 auto)$/);
    await release();
    expect(placeOf(handle('Function 3, S1'))).not.toEqual(before);
    expect([style().flex, style().height]).toEqual(['', '']);
  });

  it('continues beyond the edge as long as it stays there', async () => {
    const { log } = shown();
    const release = await hold('DT time', 80, 0);
    await drawn();
    const soon = log.length;
    await drawn();
    expect(log.length).toBeGreaterThan(soon);
    await release();
    const values = log.map((line) => Number.parseInt(line.split(' ')[1] ?? '', 10));
    expect(values).toEqual([...values].sort((a, b) => a - b));
  });

  it('puts back what is held when the timeline is removed', async () => {
    const { log, unmount } = shown();
    await hold('Function 2, S1', 0, -40);
    await drawn();
    await act(() => void unmount());
    expect(log.at(-1)).toBe('move-position 12 back.');
  });
});

describe('fingers', () => {
  const finger = (pointerId: number, clientX: number, clientY: number) => ({
    pointerId,
    pointerType: 'touch',
    buttons: 1,
    button: 0,
    clientX,
    clientY,
  });

  it('take the nearest handle within reach', async () => {
    const { log } = shown();
    const { clientX, clientY } = placeOf(handle('Function 2, S1'));
    await act(() => void fireEvent.pointerDown(picture(), finger(1, clientX + 6, clientY - 14)));
    await act(() => void fireEvent.pointerUp(picture(), finger(1, clientX + 6, clientY - 1000)));
    expect(log.at(-1)).toBe('move-position 130.');
  });

  it('take the nearer one of two handles within reach', async () => {
    const { log } = shown(
      programOf(
        'B',
        Array.from({ length: 41 }, (_, slot) => slot * 100),
      ),
    );
    const { clientX, clientY } = placeOf(handle('Function 20, S1'));
    await act(() => void fireEvent.pointerDown(picture(), finger(1, clientX + 1, clientY + 2)));
    await act(() => void fireEvent.pointerUp(picture(), finger(1, clientX + 1, clientY - 1000)));
    expect(log.at(-1)).toBe('move-position 130.');
    expect(handle('Function 20, S1').getAttribute('aria-valuenow')).toBe('130');
  });

  it('put back what they held when the page scrolls', async () => {
    const { log } = shown();
    const { clientX, clientY } = placeOf(handle('Function 2, S1'));
    await act(() => void fireEvent.pointerDown(picture(), finger(1, clientX, clientY)));
    await act(() => void fireEvent.pointerMove(picture(), finger(1, clientX, clientY - 30)));
    await drawn();
    await act(() => void fireEvent.pointerCancel(picture(), finger(1, clientX, clientY - 30)));
    expect(log.at(-1)).toBe('move-position 12 back.');
  });

  it('select the servo whose lane is tapped, but none that they move over', async () => {
    shown();
    const tap = async (dx: number): Promise<void> => {
      const at = [100, heightOf('S3')] as const;
      await act(() => void fireEvent.pointerDown(picture(), finger(1, ...at)));
      await act(() => void fireEvent.pointerUp(picture(), finger(1, at[0] + dx, at[1])));
    };
    await tap(20);
    expect(inHand()).toBe('S1');
    await tap(2);
    expect(inHand()).toBe('S3');
  });

  it('that only tremble on a handle move nothing', async () => {
    const { log } = shown();
    const { clientX, clientY } = placeOf(handle('Function 2, S1'));
    await act(() => void fireEvent.pointerDown(picture(), finger(1, clientX, clientY)));
    await act(() => void fireEvent.pointerMove(picture(), finger(1, clientX + 3, clientY - 4)));
    await drawn();
    await act(() => void fireEvent.pointerUp(picture(), finger(1, clientX + 3, clientY - 4)));
    expect(log).toEqual([]);
  });

  it.each([
    ['Function 2, S1', 1],
    ['Function 2 time', 10],
    ['DT time', 100],
  ])('find every step of %s when they are far from the handle', async (name, step) => {
    const { log } = shown();
    const { clientX, clientY } = placeOf(handle(name));
    const isTime = name.endsWith('time');
    const at = (away: number, way: number) =>
      isTime ? finger(1, clientX + way, clientY + away) : finger(1, clientX + away, clientY - way);
    const begin = standing(name);
    const seen = new Set([begin]);
    await act(() => void fireEvent.pointerDown(picture(), at(0, 0)));
    for (let way = 0; way <= 70; way += 4) {
      await act(() => void fireEvent.pointerMove(picture(), at(300, way)));
      await drawn();
      seen.add(standing(name));
    }
    expect(screen.getByText(en.timeline.finer)).toBeTruthy();
    await act(() => void fireEvent.pointerUp(picture(), at(300, 70)));
    expect(seen.size, 'the mark moves on in steps').toBeGreaterThanOrEqual(4);
    expect([...seen]).toEqual(Array.from(seen, (_, count) => begin + count * step));
    expect(log.at(-1)).toMatch(/\.$/);
  });

  it('stop the page from scrolling on a handle, but not beside one', async () => {
    shown();
    const { clientX, clientY } = placeOf(handle('DT, S1'));
    const scrolls = async (x: number, y: number): Promise<boolean> => {
      await act(() => void fireEvent.pointerDown(picture(), finger(1, x, y)));
      const free = fireEvent(picture(), new Event('touchstart', { bubbles: true, cancelable: true }));
      await act(() => void fireEvent.pointerUp(picture(), finger(1, x, y)));
      return free;
    };
    expect([await scrolls(clientX, clientY), await scrolls(clientX - 30, clientY - 60)]).toEqual([false, true]);
  });
});

describe('the keyboard', () => {
  it.each([
    ['Function 2 time', 'ArrowRight', {}, 410],
    ['Function 2 time', 'ArrowDown', {}, 390],
    ['Function 2 time', 'ArrowRight', { shiftKey: true }, 500],
    ['Function 2 time', 'PageDown', {}, 300],
    ['Function 2 time', 'Home', {}, 210],
    ['Function 2 time', 'End', {}, 590],
    ['DT time', 'ArrowLeft', {}, 17900],
    ['Motor stop time', 'ArrowUp', {}, 1010],
    ['Function 2, S1', 'ArrowUp', {}, 13],
    ['Function 2, S1', 'PageUp', {}, 22],
    ['Function 2, S1', 'Home', {}, 0],
    ['Function 2, S1', 'End', {}, 130],
  ])('%s: %s %j gives %i', async (name, pressed, more, value) => {
    const { log } = shown();
    await key(handle(name), pressed, more);
    const step = name.endsWith('time') ? 'move-time' : 'move-position';
    expect(log).toEqual([`${step} ${value}`, `${step} ${value}.`]);
  });

  it('makes one movement while a key is held', async () => {
    const { log } = shown();
    const dt = handle('DT time');
    for (let i = 0; i < 3; i++) await act(() => void fireEvent.keyDown(dt, { key: 'ArrowRight', repeat: i > 0 }));
    await act(() => void fireEvent.keyUp(dt, { key: 'ArrowRight' }));
    expect(log).toEqual(['move-time 18100', 'move-time 18200', 'move-time 18300', 'move-time 18300.']);
  });

  it('leaves a servo alone when another one is selected while a key is held', async () => {
    const { current } = shown();
    const step = handle('Function 2, S1') as SVGElement;
    await act(() => step.focus());
    await act(() => void fireEvent.keyDown(step, { key: 'ArrowUp' }));
    await choose('S2');
    const target = document.activeElement as Element;
    await act(() => void fireEvent.keyDown(target, { key: 'ArrowUp', repeat: true }));
    await act(() => void fireEvent.keyUp(target, { key: 'ArrowUp' }));
    expect(current.value.positions.map((row) => row[2])).toEqual([13, 23, 32]);
  });

  it('puts back with Escape while a key is held, else leaves the handles', async () => {
    const { log } = shown();
    const dt = handle('DT time');
    await act(() => void fireEvent.keyDown(dt, { key: 'ArrowRight' }));
    await act(() => void fireEvent.keyDown(dt, { key: 'ArrowRight', repeat: true }));
    await act(() => void fireEvent.keyDown(dt, { key: 'Escape' }));
    expect(log).toEqual(['move-time 18100', 'move-time 18200', 'move-time 18000 back.']);
    await act(() => (dt as SVGElement).focus());
    await key(dt, 'Escape');
    expect(document.activeElement).toBe(picture());
  });

  it('skips the handles with Tab, until Enter leads to them', async () => {
    shown();
    const stops = () =>
      screen.getAllByRole('slider').filter((slider) => slider.getAttribute('tabindex') === '0').length;
    expect(stops()).toBe(0);
    await act(() => picture().focus());
    await key(picture(), 'Enter');
    expect(document.activeElement).toBe(handle('Function 1 time'));
    expect(stops()).toBe(10);
    await act(() => (document.activeElement as SVGElement).blur());
    expect(stops()).toBe(0);
  });

  it('goes from mark to mark, and a screen reader says what stands there', async () => {
    shown();
    const said: (string | null)[] = [];
    for (const pressed of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'End', 'ArrowLeft', 'Home']) {
      await key(picture(), pressed);
      said.push(screen.getByRole('status').textContent);
    }
    expect(said).toEqual([
      '0.00 s, Start, S1 10, S2 20, S3 30',
      '2.00 s, Function 1, S1 11, S2 21, S3 31',
      '4.00 s, Function 2, S1 12, S2 22, S3 32',
      '3:00, DT, S1 14, S2 24, S3 34',
      '10.00 s, Function 3, S1 13, S2 23, S3 33',
      '0.00 s, Start, S1 10, S2 20, S3 30',
    ]);
    await key(picture(), 'Escape');
    expect(screen.getByRole('status').textContent).toBe('');
  });

  it('zooms', async () => {
    shown();
    const gap = () => placeOf(handle('DT, S1')).clientX - placeOf(handle('Function 3, S1')).clientX;
    const before = gap();
    await key(picture(), '+');
    expect(gap() / before).toBeCloseTo(1.5, 1);
    await key(picture(), '0');
    expect(gap()).toBeCloseTo(before, 5);
  });
});

describe('reading', () => {
  it('shows time, function and all values where the pointer is, and no more when it leaves', async () => {
    shown();
    const { clientX, clientY } = placeOf(handle('Function 2 time'));
    const over = { ...mouse, clientX: clientX + 2, clientY: clientY + 60 };
    await act(() => void fireEvent.pointerMove(picture(), over));
    await drawn();
    expect(document.querySelector('.timeline-readout')?.textContent).toBe('4.00 s Function 2');
    expect([...document.querySelectorAll('.crosshair text')].map(({ textContent }) => textContent)).toEqual([
      '12',
      '22',
      '32',
    ]);
    expect(screen.getByRole('status').textContent, 'a screen reader is not told at each movement').toBe('');
    const [, line] =
      /translate\((\S+) /.exec(document.querySelector('.crosshair')?.getAttribute('transform') ?? '') ?? [];
    expect(Number(line)).toBeCloseTo(clientX - picture().getBoundingClientRect().left, 0);
    await act(() => void fireEvent.pointerLeave(picture(), over));
    expect(screen.getByText(en.timeline.ask)).toBeTruthy();
  });

  it('reports what the mouse is over, until it leaves it or drags it', async () => {
    const model = new TimelineModel();
    shown(PROGRAM, { model });
    const pointed = () => model.pointed.value;
    const place = placeOf(handle('Function 2 time'));
    await act(() => void fireEvent.pointerMove(picture(), { ...mouse, ...place }));
    await drawn();
    expect(pointed()).toEqual({ kind: 'time', slot: 2 });
    await act(() => void fireEvent.pointerLeave(picture(), { ...mouse, ...place }));
    expect(pointed()).toBeNull();
    await act(() => void fireEvent.pointerMove(picture(), { ...mouse, ...placeOf(handle('Function 2, S1')) }));
    await drawn();
    expect(pointed()).toEqual({ kind: 'position', servo: 0, slot: 2 });
    const release = await hold('Function 2 time', 12, 0);
    expect(pointed(), 'during a drag the mouse reports nothing: the handle has the focus').toBeNull();
    await release();
  });

  it('shows the cursor when there is no pointer', () => {
    shown(PROGRAM, { cursor: signal(450) });
    expect(document.querySelector('.timeline-readout')?.textContent).toBe('4.50 s Function 2');
    expect(document.querySelectorAll('.crosshair')).toHaveLength(1);
  });

  it('says that it does not know when times fall', () => {
    shown(programOf('Q', [1000, 500, 200, 600, 18000]), { cursor: signal(300) });
    expect(document.querySelector('.timeline-readout')?.textContent).toBe('3.00 s Not known: the times fall');
    expect(document.querySelectorAll('.unknown rect')).toHaveLength(1);
    expect(screen.getByText(/^Function 2 comes before function 1. It is not known what the timer does/)).toBeTruthy();
  });

  it('says which functions are skipped', () => {
    shown(programOf('Q', [1000, 200, 400, 400, 18000]));
    expect(screen.getByText('Function 2 is skipped: function 3 comes at the same time.')).toBeTruthy();
  });

  it('names DT and the motor stop as a pilot does, beside the figure', async () => {
    shown();
    const read = (): string | null | undefined => document.querySelector('.timeline-readout')?.textContent;
    await act(() => (handle('DT time') as SVGElement).focus());
    expect(read()).toBe('3:00 min DT');
    await act(() => (handle(en.program.motorStopTime) as SVGElement).focus());
    expect(read()).toBe('10.0 s Motor stop');
  });

  it.each([
    [1000, 1],
    [900, 2],
  ])('draws a second program behind, with its name and a motor stop of %i where it is another one', (stop, marks) => {
    shown(PROGRAM, { overlay: { program: programOf('Q', [stop, 100, 400, 600, 36000]), name: 'Timer holds' } });
    expect(screen.getByText('Timer holds')).toBeTruthy();
    expect(document.querySelectorAll('.overlay path:not(.mark)').length).toBeGreaterThanOrEqual(3);
    expect(document.querySelectorAll('.overlay .mark')).toHaveLength(marks);
  });

  it('has buttons to go back only once it was zoomed, and then the focus has a place', async () => {
    shown();
    const tools = () => screen.getAllByRole('button').map((each) => each.getAttribute('aria-label'));
    const { zoomIn, zoomOut, fit } = en.timeline;
    const before = tools();
    expect(before).not.toContain(fit);
    await act(() => void fireEvent.click(screen.getByRole('button', { name: zoomIn })));
    expect(tools()).toEqual([zoomOut, zoomIn, fit, ...before.slice(1)]);
    const back = screen.getByRole('button', { name: fit });
    back.focus();
    await act(() => void fireEvent.click(back));
    expect([tools(), document.activeElement?.getAttribute('aria-label')]).toEqual([before, zoomIn]);
  });

  it('is described in one sentence', () => {
    shown();
    const about = document.getElementById(picture().getAttribute('aria-describedby') ?? '');
    expect(about?.textContent).toMatch(/^3 servos and 3 functions over time, DT at 3:00, motor stop at 10.00 s\. /);
  });
});

describe('hard programs', () => {
  const slot = (count: number, of: (at: number) => number): number[] =>
    Array.from({ length: count }, (_, at) => of(at));
  it.each<[string, TimerProgram]>([
    ['only DT', programOf('Q', [0, 18000])],
    ['all at launch', programOf('Q', [0, 0, 0, 0])],
    [
      'the most functions',
      programOf(
        'B',
        slot(126, (at) => at * 37),
      ),
    ],
    [
      'the most servos',
      programOf(
        'B',
        [0, 18000],
        slot(126, (servo) => servo).map((servo) => [servo, 130 - servo]),
      ),
    ],
    ['times that no wire carries', programOf('Q', [999999, 700000, 5, 18000])],
    ['positions past the last step', programOf('Q', [0, 100, 18000], [[255, 131, 0]])],
    ['times that fall all the way', programOf('B', [0, 500, 400, 300, 200, 100])],
  ])('%s: every handle has its place, and no figure is without one', (_, program) => {
    shown(program);
    expect(picture().innerHTML).not.toMatch(/NaN|Infinity|undefined/);
    for (const slider of screen.getAllByRole('slider'))
      expect(slider.getAttribute('transform')).toMatch(/^translate\(/);
  });
});
