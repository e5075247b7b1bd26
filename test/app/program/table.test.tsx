import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { parseTime } from '../../../src/app/editing/units.js';
import { en } from '../../tools/en.js';
import { appBench, idle } from '../bench/bench.js';
import { connected, field, goTo, key, late, press } from '../screen.js';

/** Types a text letter by letter; the focus stays. */
async function typeOut(name: string, text: string): Promise<void> {
  field(name).focus();
  for (let end = 1; end <= text.length; end++) {
    fireEvent.input(field(name), { target: { value: text.slice(0, end) } });
  }
  await idle();
}

async function enter(name: string, text: string): Promise<void> {
  field(name).focus();
  fireEvent.input(field(name), { target: { value: text } });
  field(name).blur();
  await idle();
}

/** What is said of the range that is selected. */
const size = () => document.querySelector('.range-bar > p')?.textContent;

/** Pastes at the field that has the focus. */
async function paste(text: string): Promise<void> {
  const event = new Event('paste', { bubbles: true, cancelable: true });
  Object.assign(event, { clipboardData: { getData: () => text } });
  fireEvent(document.activeElement ?? document.body, event);
  await idle();
}

/** What the preview of a paste says that changes: the name of the field, its new value and its old one. */
function pastedCells(): [name: string, to: string, from: string][] {
  const dialog = screen.getByRole('dialog', { name: 'Paste' });
  const heads = [...dialog.querySelectorAll('thead th')].map(({ textContent }) => textContent);
  return [...dialog.querySelectorAll('tbody tr')].flatMap((row) => {
    const [{ textContent: name } = { textContent: '' }, ...cells] = row.children;
    return cells.flatMap((cell, at): [string, string, string][] => {
      const from = cell.querySelector('small')?.textContent;
      if (from === undefined) return [];
      const head = heads[at + 1];
      const label = head === 'Time' ? `${name} time` : head === 'After' ? `${name} interval` : `${name}, ${head}`;
      return [[label, cell.firstChild?.textContent?.trim() ?? '', from]];
    });
  });
}

/** What Ctrl+C, or Ctrl+X, would put into the clipboard; null where that is left to the browser. */
function copied(by: 'copy' | 'cut' = 'copy'): string | null {
  let text: string | null = null;
  const event = new Event(by, { bubbles: true, cancelable: true });
  Object.assign(event, { clipboardData: { setData: (_: string, set: string) => (text = set) } });
  fireEvent(document.activeElement ?? document.body, event);
  expect(event.defaultPrevented).toBe(text !== null);
  return text;
}

describe('moving', () => {
  it.each([
    ['ArrowRight', {}, 'Function 2, S3'],
    ['ArrowLeft', {}, 'Function 2, S1'],
    ['ArrowDown', {}, 'Function 3, S2'],
    ['ArrowUp', {}, 'Function 1, S2'],
    ['Enter', {}, 'Function 3, S2'],
    ['Enter', { shiftKey: true }, 'Function 1, S2'],
  ])('%s %j goes from Function 2, S2 to %s, past notes, while the whole text is selected', async (arrow, held, to) => {
    await connected();
    for (const row of [1, 2]) await enter(`Function ${row}, S2`, '131');
    field('Function 2, S2').focus();
    await key(arrow, held);
    expect(document.activeElement).toBe(field(to));
  });

  it('to the side stays within a text that is being edited, until its end', async () => {
    await connected();
    field('Function 2, S2').focus();
    field('Function 2, S2').setSelectionRange(1, 1);
    await key('ArrowRight');
    expect(document.activeElement).toBe(field('Function 2, S2'));
    field('Function 2, S2').setSelectionRange(2, 2);
    await key('ArrowRight');
    expect(document.activeElement).toBe(field('Function 2, S3'));
  });

  it('follows the rows as shown: only the column of the times goes through the motor stop', async () => {
    await connected();
    await enter(en.program.motorStopTime, '12.3');
    field('Function 4 time').focus();
    await key('ArrowDown');
    expect(document.activeElement).toBe(field(en.program.motorStopTime));
    await key('Enter');
    expect(document.activeElement).toBe(field('Function 5 time'));
    field('Function 4, S1').focus();
    await key('ArrowDown');
    expect(document.activeElement).toBe(field('Function 5, S1'));
  });

  it('to the left of the times reaches the tools of the rows, and comes back', async () => {
    await connected();
    field('Function 3 time').focus();
    await key('ArrowLeft');
    expect(document.activeElement).toBe(screen.getByRole('button', { name: 'Tools for Function 3' }));
    await key('ArrowDown');
    await key('ArrowRight');
    expect(document.activeElement).toBe(field('Function 4 time'));
  });
});

describe('stepping', () => {
  it('goes by the step of the class with Alt and an arrow, by ten with Shift, and is one step to undo', async () => {
    await connected();
    field('Function 1 time').focus();
    await key('ArrowUp', { altKey: true });
    expect(field('Function 1 time').value).toBe('10.60');
    await key('ArrowDown', { altKey: true, shiftKey: true });
    expect(field('Function 1 time').value).toBe('9.60');
    await press('Undo change of function 1 time');
    expect(field('Function 1 time').value).toBe('10.50');
  });
});

describe('dragged text', () => {
  it.each(['Function 2, S1', 'Function 2 interval'])('neither leaves %s nor comes into it', async (name) => {
    await connected();
    field(name).focus();
    const happens = (type: string): boolean =>
      fireEvent(field(name), new Event(type, { bubbles: true, cancelable: true }));
    expect(['dragstart', 'dragover', 'drop'].map(happens)).toEqual([false, false, false]);
  });
});

describe('Escape', () => {
  it.each([
    ['Function 2, S1', '50', '51', '50'],
    ['Function 3 interval', '2', '2.10', '2.00'],
  ])('in %s takes back the steps after a typed value, and then nothing', async (name, typed, stepped, after) => {
    await connected();
    await typeOut(name, typed);
    await key('ArrowUp', { altKey: true });
    expect(field(name).value).toBe(stepped);
    await key('Escape');
    await key('Escape');
    expect(field(name).value).toBe(after);
  });
});

describe('intervals', () => {
  it('move their function and those after it, but not DT', async () => {
    await connected();
    await enter('Function 3 interval', '1');
    expect(['Function 2', 'Function 3', 'Function 4', 'DT'].map((row) => field(`${row} time`).value)).toEqual([
      '11.00',
      '12.00',
      '12.50',
      '3:00',
    ]);
    await press('Undo change of function 3');
    expect(field('Function 3 time').value).toBe('11.50');
  });

  it('that are impossible change nothing, and say why', async () => {
    await connected();
    field('Function 3 interval').focus();
    fireEvent.input(field('Function 3 interval'), { target: { value: '-99' } });
    await idle();
    expect(screen.getByRole('alert').textContent).toBe('Function 3 time: This would be before launch.');
    expect(field('Function 3 time').value).toBe('11.50');
    field('Function 3 interval').blur();
    await idle();
    expect(field('Function 3 interval').value).toBe('0.50');
  });

  it.each(['1300', '12.345', '1x'])('are not changed by %j, whatever it began with', async (text) => {
    const { editor } = await connected();
    await typeOut('Function 3 interval', text);
    expect(screen.getByRole('alert').textContent).not.toBe('');
    expect([editor.dirty.value, editor.undoStep.value]).toEqual([false, null]);
    field('Function 3 interval').blur();
    await idle();
    expect(field('Function 3 interval').value).toBe('0.50');
  });

  it('are shown again when a text has become a value', async () => {
    await connected();
    await typeOut('Function 3 interval', '700');
    await enter('Function 3 interval', '2');
    expect([field('Function 3 interval').value, field('Function 4 time').value]).toEqual(['2.00', '13.50']);
    await press('Undo change of function 3');
    expect([field('Function 3 interval').value, field('Function 4 time').value]).toEqual(['0.50', '12.00']);
  });

  it('show an undo while they are typed', async () => {
    await connected();
    await typeOut('Function 3 interval', '12');
    await key('z', { ctrlKey: true });
    expect([field('Function 3 interval').value, field('Function 3 time').value]).toEqual(['0.50', '11.50']);
  });

  it('do not count from a time that is not a value', async () => {
    await connected();
    await enter('Function 2 time', 'soon');
    await typeOut('Function 3 interval', '1');
    expect(screen.getByRole('alert').textContent).toMatch(/^Function 2 time: /);
    await key('ArrowUp', { altKey: true });
    expect(screen.getByRole('alert').textContent).toMatch(/^Function 2 time: /);
    expect(['Function 3', 'Function 4'].map((row) => field(`${row} time`).value)).toEqual(['11.50', '12.00']);
  });

  it('cannot be filled down or pasted after a time that is not a value', async () => {
    const { editor } = await connected();
    await enter('Function 2 time', 'soon');
    field('Function 3 interval').focus();
    await key('d', { ctrlKey: true });
    expect(screen.getByRole('alert').textContent).toBe(
      `Nothing was changed. Function 2 time: ${en.edits.refused.unreadable}`,
    );
    await paste('1\n1');
    const dialog = within(screen.getByRole('dialog', { name: 'Paste' }));
    expect(dialog.getByText(`Function 3 interval, “1”: ${en.edits.refused.unreadable}`)).toBeTruthy();
    await press('Cancel');
    expect(editor.changes.value).toEqual([]);
  });
});

describe('a range', () => {
  it('is selected with Shift and arrows, and copied as a spreadsheet takes it', async () => {
    await connected();
    field('Function 1 time').focus();
    expect(copied()).toBeNull();
    await key('ArrowDown', { shiftKey: true });
    for (let slot = 0; slot < 3; slot++) await key('ArrowRight', { shiftKey: true });
    expect(size()).toBe('2 functions, 4 columns');
    expect(copied()).toBe('10.50\t25\t25\n11.00\t35\t35');
    await key('Escape');
    expect(size()).toBeUndefined();
  });

  it('ends at the edge of the table', async () => {
    await connected();
    field('Start, S1').focus();
    await key('ArrowUp', { shiftKey: true });
    await key('ArrowDown', { shiftKey: true });
    expect(size()).toBe('2 rows, 1 column');
  });

  it('becomes one cell again when the pilot types', async () => {
    await connected();
    field('Function 1 time').focus();
    await key('ArrowDown', { shiftKey: true });
    expect(size()).toBe('2 functions, 1 column');
    await typeOut('Function 1 time', '10.60');
    expect(size()).toBeUndefined();
    expect(copied()).toBeNull();
  });

  it('is copied by Ctrl+X too, because no cell can be empty; the text of one field is cut as usual', async () => {
    await connected();
    field('Function 1 time').focus();
    expect(copied('cut')).toBeNull();
    await key('ArrowDown', { shiftKey: true });
    expect(copied('cut')).toBe('10.50\n11.00');
  });

  it('is stepped as a whole by Alt with an arrow, as one step of undo', async () => {
    await connected();
    const range = ['Function 1, S1', 'Function 1, S2', 'Function 2, S1', 'Function 2, S2'];
    const values = () => range.map((name) => Number(field(name).value));
    const before = values();
    field('Function 1, S1').focus();
    await key('ArrowDown', { shiftKey: true });
    await key('ArrowRight', { shiftKey: true });
    await key('ArrowUp', { altKey: true });
    await key('ArrowUp', { altKey: true, shiftKey: true });
    expect([values(), size()]).toEqual([before.map((each) => each + 11), '2 functions, 2 columns']);
    await press('Undo change of 4 values');
    expect(values()).toEqual(before);
    field(en.program.idleThrottle).focus();
    const throttle = Number(field(en.program.idleThrottle).value);
    await key('ArrowUp', { altKey: true });
    expect([values(), Number(field(en.program.idleThrottle).value)], 'a field outside of it').toEqual([
      before,
      throttle + 1,
    ]);
  });

  it('that cannot be stepped as a whole is not, and says why', async () => {
    const { editor } = await connected();
    await enter('Function 2, S1', '130');
    field('Function 1, S1').focus();
    await key('ArrowDown', { shiftKey: true });
    await key('ArrowUp', { altKey: true });
    expect([field('Function 1, S1').value, field('Function 2, S1').value]).toEqual(['25', '130']);
    expect(screen.getByRole('alert').textContent).toMatch(/^Nothing was changed\. Function 2, S1: /);
    expect(editor.changes.value).toHaveLength(1);
  });

  it('is filled down with Ctrl+D', async () => {
    await connected();
    field('Function 1, S1').focus();
    await key('ArrowDown', { shiftKey: true });
    await key('ArrowDown', { shiftKey: true });
    await key('D', { ctrlKey: true, shiftKey: true });
    expect(field('Function 2, S1').value, 'Ctrl+Shift+D belongs to the browser').toBe('35');
    await key('d', { ctrlKey: true });
    expect(['Function 2, S1', 'Function 3, S1', 'Function 4, S1'].map((name) => field(name).value)).toEqual([
      '25',
      '25',
      '55',
    ]);
    await press('Undo fill down of 2 values');
    expect(field('Function 2, S1').value).toBe('35');
  });
});

describe('a paste', () => {
  it('of several cells is shown first, and done as one step', async () => {
    await connected();
    field('Function 2, S1').focus();
    await paste('1\t2\n3\t4');
    const dialog = within(screen.getByRole('dialog', { name: 'Paste' }));
    expect(pastedCells()).toEqual([
      ['Function 2, S1', '1', '35'],
      ['Function 2, S2', '2', '35'],
      ['Function 3, S1', '3', '45'],
      ['Function 3, S2', '4', '45'],
    ]);
    expect(field('Function 2, S1').value).toBe('35');
    fireEvent.click(dialog.getByRole('button', { name: 'Paste' }));
    await idle();
    expect(['Function 2, S1', 'Function 3, S2'].map((name) => field(name).value)).toEqual(['1', '4']);
    await press('Undo paste of 4 values');
    expect(field('Function 3, S2').value).toBe('45');
  });

  it.each([
    ['1\tup', 1, false],
    ['7x\tup', 0, true],
  ])('of %j says what cannot be pasted', async (text, changes, disabled) => {
    await connected();
    field('Function 2, S1').focus();
    await paste(text);
    const dialog = within(screen.getByRole('dialog', { name: 'Paste' }));
    const { problems, lead, apply } = en.edits.pasting;
    expect([dialog.getByText(problems), dialog.getByText(lead({ count: changes }))]).toHaveLength(2);
    expect(dialog.getByRole<HTMLButtonElement>('button', { name: apply }).disabled).toBe(disabled);
  });

  it('asks what a name means that is not known, and pastes nothing before', async () => {
    const { editor } = await connected();
    field('Function 9, S3').focus();
    await paste('Function\tZeit\tS1\nF2\t11.5\t40\nMotor stop\t9\t');
    const dialog = within(screen.getByRole('dialog', { name: 'Paste' }));
    const apply = dialog.getByRole<HTMLButtonElement>('button', { name: en.edits.pasting.apply });
    expect([dialog.getByText(en.edits.pasting.asks), apply.disabled]).toEqual([expect.anything(), true]);
    const asked = dialog.getByRole('combobox', { name: '“Zeit”' });
    fireEvent.change(asked, { target: { value: 'time' } });
    await idle();
    const read = pastedCells().map(([name, to, from]) => [name, parseTime(to), parseTime(from)]);
    expect(read).toEqual([
      [en.program.motorStopTime, { value: 900 }, { value: 1000 }],
      ['Function 2 time', { value: 1150 }, { value: 1100 }],
      ['Function 2, S1', { value: 4000 }, { value: 3500 }],
    ]);
    expect([apply.disabled, editor.changes.value]).toEqual([false, []]);
    fireEvent.click(apply);
    await idle();
    expect(editor.changes.value.map(({ to }) => to)).toEqual([900, 1150, 40]);
  });

  it('that is cancelled leaves no trace', async () => {
    const { editor } = await connected();
    field('Function 2, S1').focus();
    await paste('1\t2');
    await press('Cancel');
    expect([editor.dirty.value, editor.undoStep.value]).toEqual([false, null]);
  });

  it.each([
    ['empty cells', '\t\n', en.edits.table.range.clipboardClosed],
    // As if it was typed.
    ['one value with an empty cell after it', '7\t', undefined],
  ])('of %s has no preview and changes nothing', async (_, text, said) => {
    const { editor } = await connected();
    field('Function 2, S1').focus();
    await paste(text);
    const why = screen.queryByRole('alert')?.textContent;
    expect([screen.queryByRole('dialog'), editor.dirty.value, why?.includes(said ?? '')]).toEqual([
      null,
      false,
      said && true,
    ]);
  });
});

describe('many fields at once', () => {
  it('a row is put back', async () => {
    await connected();
    await enter('Function 2, S1', '7');
    await enter('Function 2 time', 'x');
    await enter('Function 3, S1', '8');
    await press('Tools for Function 2');
    await press('Put back Function 2');
    expect(['Function 2, S1', 'Function 2 time', 'Function 3, S1'].map((name) => field(name).value)).toEqual([
      '35',
      '11.00',
      '8',
    ]);
  });

  it('everything later is shifted, DT only on request', async () => {
    await connected();
    await press('Tools for Function 2');
    fireEvent.input(field(en.edits.shift.by), { target: { value: '0,3' } });
    await press('Later');
    expect(['Function 1', 'Function 2', 'Function 9', 'DT'].map((row) => field(`${row} time`).value)).toEqual([
      '10.50',
      '11.30',
      '14.80',
      '3:00',
    ]);
    fireEvent.click(screen.getByRole('checkbox', { name: 'Move DT too' }));
    await press('Earlier');
    expect(field('DT time').value).toBe('2:59.70');
    await press('Undo shift from function 2 by -0.30 s');
    expect(field('DT time').value).toBe('3:00');
  });
});

describe('what is typed next replaces the whole text', () => {
  const marked = (name: string): boolean => {
    const { selectionStart, selectionEnd, value } = field(name);
    return selectionStart === 0 && selectionEnd === value.length;
  };

  it.each([
    ['ArrowDown', 'DT, S1'],
    ['Enter', 'DT, S1'],
    ['ArrowRight', 'Function 2, S3'],
    ['ArrowUp', 'Motor stop time'],
  ])('after %s at the edge: %s', async (pressed, name) => {
    await connected();
    field(name).focus();
    const input = field(name);
    expect(fireEvent.keyDown(input, { key: pressed }), 'the browser would drop the selection').toBe(false);
    expect([document.activeElement, marked(name)]).toEqual([input, true]);
    input.setSelectionRange(input.value.length, input.value.length);
    await key(pressed);
    expect([document.activeElement, marked(name)]).toEqual([input, true]);
  });

  it.each([
    ['before', 0, true],
    ['behind', 4, true],
    ['between the digits of', 2, false],
  ])('after a second click %s it', async (_, caret, whole) => {
    await connected();
    const input = field('DT time');
    input.focus();
    fireEvent.mouseDown(input, { button: 0 });
    // As the browser does.
    input.setSelectionRange(caret, caret);
    fireEvent.click(input);
    await idle();
    expect([input.value, marked('DT time')]).toEqual(['3:00', whole]);
  });

  it('but not what was typed at once after it', async () => {
    await connected();
    const input = field('Function 2, S1');
    input.focus();
    fireEvent.mouseDown(input, { button: 0 });
    input.setSelectionRange(2, 2);
    fireEvent.click(input);
    // A slow device hears the key before anything that waits.
    fireEvent.input(input, { target: { value: '7' } });
    input.setSelectionRange(1, 1);
    await idle();
    expect([input.value, marked('Function 2, S1')]).toEqual(['7', false]);
  });

  it('but not after a click of somebody who edits the text', async () => {
    await connected();
    const input = field('DT time');
    input.focus();
    input.setSelectionRange(2, 2);
    fireEvent.mouseDown(input, { button: 0 });
    input.setSelectionRange(0, 0);
    fireEvent.click(input);
    await idle();
    expect([input.selectionStart, input.selectionEnd]).toEqual([0, 0]);
  });
});

describe('undo by keys', () => {
  it('works in a field, and not in a text that is no part of the program', async () => {
    await connected();
    await enter('Function 2, S1', '7');
    await press('Tools for Function 2');
    field(en.edits.shift.by).focus();
    await key('z', { ctrlKey: true });
    expect(field('Function 2, S1').value).toBe('7');
    field('Function 2, S1').focus();
    await key('z', { metaKey: true });
    expect(field('Function 2, S1').value).toBe('35');
    await key('z', { ctrlKey: true, shiftKey: true });
    expect(field('Function 2, S1').value).toBe('7');
    await key('z', { ctrlKey: true });
    await key('y', { ctrlKey: true });
    expect(field('Function 2, S1').value).toBe('7');
  });

  it('and filling down work on a keyboard without Latin letters', async () => {
    await connected();
    field('Function 2, S1').focus();
    await key('в', { code: 'KeyD', ctrlKey: true });
    const filled = field('Function 2, S1').value;
    await key('я', { code: 'KeyZ', ctrlKey: true });
    const undone = field('Function 2, S1').value;
    await key('н', { code: 'KeyY', ctrlKey: true });
    expect([filled, undone, field('Function 2, S1').value]).toEqual(['25', '35', '25']);
  });

  it('does nothing while the timer is read, not even in the field', async () => {
    const { session } = await connected();
    await enter('Function 2, S1', '7');
    const reading = session.reader.read();
    field('Function 2, S1').focus();
    expect(
      fireEvent.keyDown(field('Function 2, S1'), { key: 'z', ctrlKey: true }),
      'the browser does not undo in the field',
    ).toBe(false);
    await idle();
    await reading;
    expect(field('Function 2, S1').value).toBe('7');
  });
});

describe('DT', () => {
  it('is set by a preset', async () => {
    await connected();
    const presets = within(screen.getByRole('group', { name: 'DT presets' })).getAllByRole('button', { name: /^DT/ });
    const shown = presets.map(({ textContent }) => textContent);
    expect(shown.join(', ')).toBe('20 s, 1 min, 3 min, 4 min, 5 min, 6 min, 8 min, 10 min');
    await press('DT 6 min');
    expect(field('DT time').value).toBe('6:00');
    await press('Undo change of DT');
    expect(field('DT time').value).toBe('3:00');
  });

  it('has presets that the pilot sets and the page keeps', async () => {
    await connected();
    await goTo('settings');
    const presets = () => field(en.edits.presets.title);
    const say = async (text: string): Promise<void> => {
      fireEvent.change(presets(), { target: { value: text } });
      await idle();
    };
    // 2,30 may be 2 min 30 s or 2.3 s: other fields ask, and this one does not guess.
    for (const wrong of [
      '20 s, soon',
      '11:00',
      '20 s, 2,30',
      '2.30',
      Array.from({ length: 25 }, (_, at) => at).join(', '),
    ]) {
      await say(wrong);
      expect([screen.getByRole('alert').textContent, presets().value]).toEqual([en.edits.presets.refused, wrong]);
    }
    await say('2:00,50');
    expect([screen.queryByRole('alert'), presets().value]).toEqual([null, '2:00.5 min']);
    await say('3:00, 20; 2:30 min, 20 s');
    expect([screen.queryByRole('alert'), presets().value]).toEqual([null, '20 s, 2:30 min, 3 min']);
    const again = await appBench();
    expect(again.preferences.presets.value).toEqual([2000, 15000, 18000]);
  });
});

describe('a time that can be read in two ways', () => {
  it.each<[where: string, text: string, answers: [string, string], at: 0 | 1, shown: string]>([
    ['DT time', '2.30', ['2 min 30 s', '2.3 s'], 0, '2:30'],
    ['DT time', '2.3', ['2 min 30 s', '2.3 s'], 1, '2.30'],
    ['DT time', '230', ['2 min 30 s', '230 s, 3:50'], 1, '3:50'],
    ['DT time', '3', ['3 min', '3 s'], 0, '3:00'],
    ['Function 4 time', '130', ['1 min 30 s', '130 s, 2:10'], 0, '1:30'],
  ])(
    'brings a question in %s after %j, and blocks until the pilot answers',
    async (where, text, answers, at, shown) => {
      const { editor } = await connected();
      const before = editor.working.value;
      await typeOut(where, text);
      expect(
        screen.queryByRole('button', { name: answers[0] }),
        'no question comes while the pilot may still be typing',
      ).toBeNull();
      await key('Enter');
      expect(document.activeElement, 'the focus stays in the field until the answer').toBe(field(where));
      const asked = within(screen.getByRole('group', { name: `What ${where} means` }));
      expect(asked.getAllByRole('button').map(({ textContent }) => textContent)).toEqual(answers);
      expect([editor.working.value?.times, editor.blocked.value]).toEqual([before?.times, true]);
      fireEvent.click(asked.getByRole('button', { name: answers[at] }));
      await idle();
      expect([field(where).value, editor.blocked.value]).toEqual([shown, false]);
      expect(screen.queryByRole('group', { name: /^What/ })).toBeNull();
    },
  );

  it('brings the question when the field is left, and Escape puts the value back', async () => {
    const { editor } = await connected();
    await enter('DT time', '4:00');
    await enter('DT time', '2.30');
    const [first] = screen.getAllByRole('button', { name: '2 min 30 s' });
    first?.focus();
    await key('Escape');
    expect([field('DT time').value, editor.blocked.value]).toEqual(['4:00', false]);
    expect(document.activeElement).toBe(field('DT time'));
  });

  it('brings the question in an interval of DT, and nothing moves before the answer', async () => {
    const { editor } = await connected();
    const last = editor.working.value?.times[9] ?? 0;
    await typeOut('DT interval', '2.30');
    await key('Enter');
    expect([document.activeElement, editor.dirty.value]).toEqual([field('DT interval'), false]);
    fireEvent.click(screen.getByRole('button', { name: '2 min 30 s' }));
    await idle();
    expect([field('DT interval').value, editor.working.value?.times[10]]).toEqual(['2:30', last + 15000]);
  });

  it('is read as seconds in a pasted table, which says so', async () => {
    await connected();
    field('Function 9 time').focus();
    await paste('130\n2.30');
    const said = within(screen.getByRole('dialog')).getAllByText(/is read as/);
    expect(said.map(({ textContent }) => textContent)).toEqual([
      'Function 9 time: “130” is read as 2 min 10 s.',
      'DT: “2.30” is read as 2.3 s.',
    ]);
  });
});

describe('figures and their units', () => {
  const describedBy = (name: string): string[] => {
    const ids = (field(name).getAttribute('aria-describedby') ?? '').split(' ').filter((id) => id !== '');
    return ids.map((id) => document.getElementById(id)?.textContent ?? '');
  };

  it('are seconds or minutes, also those of an old value', async () => {
    await connected();
    expect(['Function 2 time', en.program.motorStopTime, 'DT time'].map(describedBy)).toEqual([['s'], ['s'], ['min']]);
    await enter('DT time', '20');
    await enter(en.program.motorStopTime, '9.55');
    await late();
    expect([describedBy('DT time').slice(0, 2), describedBy(en.program.motorStopTime).slice(0, 2)]).toEqual([
      ['s', 'was 3:00 min'],
      ['s', 'was 10.0 s'],
    ]);
  });

  it('stand at a row in minutes, under a heading that says seconds', async () => {
    await connected();
    const rows = (): (string | null | undefined)[] =>
      [...document.querySelectorAll('.row-unit')].map((unit) => unit.closest('th')?.firstElementChild?.textContent);
    expect(rows()).toEqual(['DT']);
    await enter('Function 9 time', '1:05');
    await enter(en.program.motorStopTime, '1:00');
    expect(rows()).toEqual(['Motor stop', 'Function 9', 'DT']);
  });
});

describe('the checks', () => {
  it('correct an obvious fault, as one undo step', async () => {
    await connected();
    await enter('Function 3 time', '10.50');
    const fix = 'Set to 11.1 s: Function 3 time';
    await expect.poll(() => screen.queryByRole('button', { name: fix })).not.toBeNull();
    await press(fix);
    expect(field('Function 3 time').value).toBe('11.10');
    await press('Undo change of function 3 time');
    expect(field('Function 3 time').value).toBe('10.50');
  });

  it('begin with the worst', async () => {
    await connected();
    await enter('Function 2 time', '11.03');
    await enter('Function 5 time', '10.50');
    await enter('Function 9, S3', '200');
    const { error, serious, warning } = en.program.severity;
    const said = (): (string | null)[] =>
      [...document.querySelectorAll('.checks strong')].map((each) => each.textContent);
    await expect.poll(said).toEqual([error, serious, warning]);
  });
});
