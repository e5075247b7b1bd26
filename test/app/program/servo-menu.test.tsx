import { fireEvent, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { button, connected, field, key, press, type } from '../screen.js';

const { stepServo: words } = en.edits;
const stops = (): (string | null)[] => [...document.querySelectorAll('.stops')].map((line) => line.textContent);

function put(text: string): void {
  fireEvent.input(field(words.by), { target: { value: text } });
}

describe('all positions of a servo', () => {
  it('go one step up or down, or as many as are typed, each time as one step with its name', async () => {
    const { editor } = await connected();
    const [first = [], second = [], third] = editor.working.value?.positions ?? [];
    const by = (steps: number): (readonly number[] | undefined)[] => [first, second.map((at) => at + steps), third];
    await press('Tools for S2');
    await press('+1');
    expect(editor.working.value?.positions).toEqual(by(1));
    await press('−1');
    await press('−1');
    put(' +3');
    await press(words.step);
    expect(editor.working.value?.positions).toEqual(by(2));
    put('-4');
    await press(words.step);
    expect(editor.working.value?.positions).toEqual(by(-2));
    await press('Undo S2 by −4');
    await press('Undo S2 by +3');
    expect(editor.working.value?.positions).toEqual(by(-1));
    expect(editor.working.value?.times).toEqual(editor.baseline.value?.times);
  });

  it('go from the first selected function on, if that is chosen', async () => {
    const { editor } = await connected();
    const before = editor.working.value?.positions[1] ?? [];
    await press('Tools for S2');
    expect(screen.queryByRole('radio', { name: words.all })).toBeNull();
    await press('Done');
    field('Function 7, S3').focus();
    await key('ArrowUp', { shiftKey: true });
    await key('ArrowUp', { shiftKey: true });
    await press('Tools for S2');
    // A digit ends the range.
    put('3');
    fireEvent.click(screen.getByRole('radio', { name: 'From function 5 on' }));
    await press(words.step);
    expect(editor.working.value?.positions[1]).toEqual(before.map((at, slot) => at + (slot < 5 ? 0 : 3)));
    await press('Undo S2 by +3, from function 5');
    expect(editor.changes.value).toEqual([]);
  });

  it('take a text into their field, whatever range is selected', async () => {
    await connected();
    field('Function 7, S3').focus();
    await key('ArrowUp', { shiftKey: true });
    await press('Tools for S2');
    field(words.by).focus();
    for (const kind of ['paste', 'copy', 'cut']) {
      const event = new Event(kind, { bubbles: true, cancelable: true });
      const clipboardData = { getData: () => '1\t2\n3\t4', setData: () => {} };
      fireEvent(field(words.by), Object.assign(event, { clipboardData }));
      await idle(0);
      expect([kind, event.defaultPrevented, screen.queryByRole('dialog', { name: 'Paste' })]).toEqual([
        kind,
        false,
        null,
      ]);
    }
  });

  it('stop at the ends of the servo, which is said before', async () => {
    const { editor } = await connected();
    await type('Function 7, S2', '129');
    await type('Function 8, S2', '130');
    await type('Function 9, S2', '130');
    await type('Start, S2', '2');
    await press('Tools for S2');
    expect(stops()).toEqual(['+1: functions 8 to 9 stop at 130.']);
    put('3');
    expect(stops()).toEqual(['+1: functions 8 to 9 stop at 130.', '+3: functions 7 to 9 stop at 130.']);
    put('-3');
    expect(stops().at(-1)).toBe('−3: start stops at 0.');
    put('3');
    await press(words.step);
    expect(editor.working.value?.positions[1]?.slice(7, 10)).toEqual([130, 130, 130]);
    await press('Undo S2 by +3');
    expect(editor.working.value?.positions[1]?.slice(7, 10)).toEqual([129, 130, 130]);
  });

  it('stay where a text is no value, in the table or in the tools, and the reason is said', async () => {
    const { editor } = await connected();
    await type('Function 4, S2', 'x');
    await press('Tools for S2');
    await press('+1');
    expect(screen.getByRole('alert').textContent).toContain(en.edits.refused.unreadable);
    put('2.5');
    await press(words.step);
    expect(screen.getByRole('alert').textContent).toBe(en.unreadable['not-a-whole-number']);
    expect(editor.changes.value).toEqual([]);
  });

  it('are reached by keys, with the selected cells as they are', async () => {
    await connected();
    field('Start, S2').focus();
    await key('ArrowUp');
    expect(document.activeElement).toBe(button('Tools for S2'));
    await key('ArrowRight');
    await key('ArrowDown');
    expect(document.activeElement).toBe(field('Start, S3'));
    field('Function 5, S1').focus();
    await key('ArrowUp', { ctrlKey: true });
    await press('Tools for S1');
    expect(document.activeElement).toBe(field(words.by));
    expect(screen.getByRole('radio', { name: 'From function 5 on' })).toBeTruthy();
    await key('Escape');
    expect([screen.queryByRole('form'), document.activeElement]).toEqual([null, button('Tools for S1')]);
  });
});
