import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { connected, field, key } from '../screen.js';

/** What a finger does: it comes down, the focus goes where it may, and the tap ends as a click. */
async function tap(name: string, pointerType = 'touch'): Promise<void> {
  fireEvent.pointerDown(field(name), { pointerType });
  field(name).focus();
  fireEvent.click(field(name));
  await idle();
}

function sheet(name: string): ReturnType<typeof within> {
  return within(screen.getByRole('region', { name: `Keys for ${name}` }));
}

function sheets(): number {
  return screen.queryAllByRole('region', { name: /^Keys for/ }).length;
}

/** Presses keys of the sheet that is there, by what stands on them. */
async function press(...keys: string[]): Promise<void> {
  for (const name of keys) {
    const keys = within(screen.getByRole('region', { name: /^Keys for/ }));
    const key = keys.getByRole('button', { name });
    fireEvent.pointerDown(key, { pointerType: 'touch' });
    fireEvent.click(key);
    await idle();
  }
}

/** Fields of the program for which a keyboard of the screen would come up. */
function withKeyboard(): number {
  return document.querySelectorAll('.value > input:is([inputmode="decimal"], [inputmode="numeric"])').length;
}

describe('the sheet', () => {
  it.each(['touch', 'pen'])('opens for a field that is pressed by %s, in place of the keyboard', async (pointer) => {
    await connected();
    await tap('Function 4, S2', pointer);
    expect(sheet('Function 4, S2').getByRole('status').textContent).toBe('55');
    expect(withKeyboard()).toBe(0);
    expect(document.activeElement).toBe(field('Function 4, S2'));
  });

  it('does not open for a mouse or for keys', async () => {
    await connected();
    await tap('Function 4, S2', 'mouse');
    await key('ArrowDown');
    expect(document.activeElement).toBe(field('Function 5, S2'));
    expect([sheets(), withKeyboard() > 40]).toEqual([0, true]);
  });

  it('closes for a hardware keyboard, which types into the field, and opens again with the next tap', async () => {
    await connected();
    await tap('Function 4, S2');
    await press('+1');
    await key('ArrowUp', { altKey: true });
    expect([field('Function 4, S2').value, sheets()]).toEqual(['57', 0]);
    expect(document.activeElement).toBe(field('Function 4, S2'));
    await key('ArrowDown');
    expect([document.activeElement, sheets()]).toEqual([field('Function 5, S2'), 0]);
    await tap('Function 5, S2');
    expect(sheets()).toBe(1);
  });

  it('does not come under a finger that comes down after keys: it may mean something else', async () => {
    await connected();
    await key('ArrowDown');
    field('Function 4, S2').focus();
    await key('1');
    const write = screen.getByRole('button', { name: /^Write/ });
    fireEvent.pointerDown(write, { pointerType: 'touch' });
    await idle();
    expect(sheets()).toBe(0);
    write.focus();
    fireEvent.click(write);
    await idle();
    expect(sheets()).toBe(0);
    // A scroll over the field of the keys ends without a click. A tap there asks for the sheet.
    field('Function 4, S2').focus();
    await key('2');
    fireEvent.pointerDown(field('Function 4, S2'), { pointerType: 'touch' });
    fireEvent.pointerUp(field('Function 4, S2'), { pointerType: 'touch' });
    await idle();
    expect(sheets()).toBe(0);
    await tap('Function 4, S2');
    expect(sheets()).toBe(1);
  });

  it('opens at once on a touch screen, also when a button brings the focus', async () => {
    vi.spyOn(globalThis, 'matchMedia').mockImplementation(
      (query) => ({ matches: query === '(pointer: coarse)' }) as MediaQueryList,
    );
    await connected();
    field('DT time').focus();
    await idle();
    expect(sheet('DT time').getByRole('status').textContent).toBe('3:00 min');
  });

  it('closes with “Done”, and with the focus', async () => {
    await connected();
    await tap('Function 4, S2');
    await press('Done');
    expect([sheets(), document.activeElement]).toEqual([0, document.body]);
    await tap('Function 4, S2');
    field('Function 4, S2').blur();
    await idle();
    expect(sheets()).toBe(0);
  });
});

describe('its keys', () => {
  it('replace the value, then add to it, or at the caret after a tap there; the last one can be deleted', async () => {
    await connected();
    await tap('Function 4, S2');
    await press('7');
    expect(field('Function 4, S2').value).toBe('7');
    await press('2', '1', en.edits.sheet.erase);
    expect(field('Function 4, S2').value).toBe('72');
    field('Function 4, S2').setSelectionRange(0, 0);
    await press('1');
    expect(field('Function 4, S2').value).toBe('172');
    expect(
      sheet('Function 4, S2').getByText(en.findings['position-out-of-range']({ min: '0', max: '130' })),
    ).toBeTruthy();
  });

  it('include a colon and a point for a time, and the rows above and below for a position', async () => {
    await connected();
    await tap('DT time');
    await press('2', ':', '0', '5', '.', '5');
    expect(field('DT time').value).toBe('2:05.5');
    await tap('DT, S2');
    expect(sheet('DT, S2').queryByRole('button', { name: ':' })).toBeNull();
    await press('Go to ↑ 9');
    expect(document.activeElement).toBe(field('Function 9, S2'));
    await press('Go to ↓ DT');
    expect(document.activeElement).toBe(field('DT, S2'));
    expect(
      sheet('DT, S2').queryByRole('button', { name: /↓/ }),
      'DT is the last row, so there is no key to go down',
    ).toBeNull();
  });

  it.each([
    ['Function 4, S2', ['−10', '−1', '+1', '+10'], ['45', '44', '45', '55']],
    ['Function 4 time', ['−1 s', '−0.1 s', '+0.1 s', '+1 s'], ['11.00', '10.90', '11.00', '12.00']],
    ['Function 4 interval', ['+1 s', '+0.1 s', '−0.1 s', '−1 s'], ['1.50', '1.60', '1.50', '0.50']],
    ['DT time', ['−10 s', '−1 s', '+1 s', '+10 s'], ['2:50', '2:49', '2:50', '3:00']],
  ])('step %s by the steps of its class', async (name, steps, values) => {
    await connected();
    await tap(name);
    for (const [at, step] of steps.entries()) {
      await press(step);
      expect(field(name).value).toBe(values[at]);
    }
  });

  it('keep stepping while they are held, and do not step again on release', async () => {
    await connected();
    await tap('Function 4, S2');
    const plus = sheet('Function 4, S2').getByRole('button', { name: '+1' });
    fireEvent.pointerDown(plus, { pointerType: 'touch', isPrimary: true });
    await idle(449);
    const before = field('Function 4, S2').value;
    await idle(1 + 2 * 90);
    fireEvent.pointerUp(plus);
    fireEvent.click(plus);
    await idle();
    expect([before, field('Function 4, S2').value]).toEqual(['55', '58']);
    await press('+1');
    expect(field('Function 4, S2').value).toBe('59');
  });

  it.each([
    ['another button of the mouse is pressed', { button: 2, buttons: 2 }, { buttons: 2 }, '55'],
    ['another button of the mouse stays down', { button: 0, buttons: 1 }, { buttons: 2 }, '56'],
    ['the finger moves on the key', { button: 0, buttons: 1 }, { buttons: 1 }, '60'],
    ['somebody else gets the screen', { button: 0, buttons: 1 }, null, '56'],
  ])('step only while they are pressed: %s', async (_, down, moved, after) => {
    await connected();
    await tap('Function 4, S2');
    const plus = sheet('Function 4, S2').getByRole('button', { name: '+1' });
    fireEvent.pointerDown(plus, { ...down, isPrimary: true });
    await idle(450);
    if (moved) fireEvent.pointerMove(plus, { ...moved, isPrimary: true });
    else fireEvent.blur(window);
    await idle(4 * 90);
    fireEvent.pointerCancel(plus);
    expect(field('Function 4, S2').value).toBe(after);
  });

  it('begin a new value after a step, and after Put back', async () => {
    await connected();
    await tap('Function 4, S2');
    await press('+1', '8', '1');
    expect(field('Function 4, S2').value).toBe('81');
    expect(sheet('Function 4, S2').getByText('was 55')).toBeTruthy();
    await press('Put back');
    expect(field('Function 4, S2').value).toBe('55');
    expect(sheet('Function 4, S2').queryByRole('button', { name: 'Put back' })).toBeNull();
    await press('9');
    expect(field('Function 4, S2').value).toBe('9');
  });

  it('go along the row and on into the next one', async () => {
    await connected();
    await tap('Function 4, S2');
    await press('Go to S3 ›');
    expect(document.activeElement).toBe(field('Function 4, S3'));
    await press('Go to 5 ›');
    expect(document.activeElement).toBe(field('Function 5 time'));
    await press('Go to After ›', 'Go to S1 ›', 'Go to ‹ After');
    expect(document.activeElement).toBe(field('Function 5 interval'));
  });

  it('pass through the motor stop at its row', async () => {
    await connected();
    await tap('Function 1 time');
    await press('Go to ‹ Motor', 'Go to 1 ›');
    expect(document.activeElement).toBe(field('Function 1 time'));
  });

  it('make one undo step of everything done at one field', async () => {
    const { editor } = await connected();
    await tap('Function 4, S2');
    await press('7', '2', 'Go to S3 ›', '+1', '+1');
    editor.undo();
    await idle();
    expect([field('Function 4, S2').value, field('Function 4, S3').value]).toEqual(['72', '55']);
    editor.undo();
    await idle();
    expect(field('Function 4, S2').value).toBe('55');
  });
});

describe('a text that can be read in several ways', () => {
  it.each(['Done', 'Go to 9 ›'])('brings a question in the sheet after “%s”, and nowhere else', async (way) => {
    await connected();
    await tap('Function 8, S3');
    await press('Go to 9 ›', '2', '3', '0', way === 'Done' ? way : 'Go to After ›');
    expect(document.activeElement).toBe(field('Function 9 time'));
    expect(screen.getAllByRole('group', { name: 'What Function 9 time means' })).toHaveLength(1);
    await press('2 min 30 s');
    expect(field('Function 9 time').value).toBe('2:30');
    expect(screen.queryByRole('group', { name: 'What Function 9 time means' })).toBeNull();
    await press('Done');
    expect(sheets()).toBe(0);
  });

  it('may stay unanswered: then the page asks at the field', async () => {
    await connected();
    await tap('DT time');
    await press('2', '3', '0', 'Done', 'Done');
    expect([sheets(), field('DT time').value]).toEqual([0, '230']);
    const asked = within(screen.getByRole('group', { name: 'What DT time means' }));
    fireEvent.click(asked.getByRole('button', { name: '2 min 30 s' }));
    await idle();
    expect(field('DT time').value).toBe('2:30');
  });

  it('is answered as an interval, too', async () => {
    await connected();
    await tap('DT interval');
    await press('2', '3', '0', 'Go to S1 ›');
    expect(document.activeElement).toBe(field('DT interval'));
    await press('2 min 30 s');
    expect(field('DT interval').value).toBe('2:30');
  });
});
