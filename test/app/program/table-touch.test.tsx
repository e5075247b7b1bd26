import { fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { connected, field, key, press } from '../screen.js';

describe('a range without a Shift key', () => {
  /** What a finger, and a mouse, does to a cell; the focus goes where it may. */
  const tap = async (name: string): Promise<void> => {
    fireEvent.pointerDown(field(name), { pointerType: 'touch' });
    fireEvent.pointerUp(field(name), { pointerType: 'touch' });
    if (fireEvent.mouseDown(field(name), { button: 0 })) field(name).focus();
    fireEvent.click(field(name));
    await idle();
  };
  const pick = async (from: string, to: string): Promise<void> => {
    await tap(from);
    await press(en.edits.sheet.selectRange);
    await tap(to);
  };
  /** Puts this in the place of the browser's clipboard. */
  const clipboard = (given: Partial<Clipboard>): void => {
    Object.defineProperty(navigator, 'clipboard', { value: given, configurable: true });
  };
  const own = Object.getOwnPropertyDescriptor(navigator, 'clipboard');
  afterEach(() => {
    Reflect.deleteProperty(navigator, 'clipboard');
    if (own) Object.defineProperty(navigator, 'clipboard', own);
  });
  const marked = (): number => document.querySelectorAll('td.selected').length;

  it('goes from the first cell to the cell tapped last, and no keyboard opens', async () => {
    await connected();
    await tap('Function 2, S1');
    expect(document.querySelector('.range-bar')).toBeNull();
    await press(en.edits.sheet.selectRange);
    expect(screen.getByText(en.edits.table.range.pick)).toBeTruthy();
    expect(marked()).toBe(1);
    await tap('Function 4, S2');
    expect(screen.getByText('3 functions, 2 columns')).toBeTruthy();
    expect(marked()).toBe(6);
    expect(document.activeElement).toBe(document.body);
    await tap('Start, S3');
    expect(screen.getByText('3 rows, 3 columns')).toBeTruthy();
    // As a screen reader comes to it.
    field('Function 2, S2').focus();
    await idle();
    expect(screen.getByText('1 function, 2 columns')).toBeTruthy();
    expect(document.activeElement).toBe(document.body);
    expect(marked()).toBe(2);
    await press('Done');
    expect([marked(), screen.queryByRole('button', { name: 'Fill down' })]).toEqual([0, null]);
    await tap('Function 3, S1');
    expect(document.activeElement).toBe(field('Function 3, S1'));
  });

  it('is copied in the same way as by keys', async () => {
    await connected();
    const texts: string[] = [];
    clipboard({ writeText: async (given) => void texts.push(given) });
    await pick('Function 1 time', 'Function 2, S2');
    await press('Copy');
    expect(texts).toEqual(['10.50\t25\t25\n11.00\t35\t35']);
    expect(screen.getByText('Copied.', { exact: true })).toBeTruthy();
    await tap('Function 3, S2');
    expect(
      screen.queryByText('Copied.', { exact: true }),
      '“Copied.” is gone once another range is selected',
    ).toBeNull();
  });

  it('is filled down in the same way as by keys', async () => {
    await connected();
    await pick('Function 1, S1', 'Function 3, S2');
    await press('Fill down');
    expect(['Function 3, S1', 'Function 3, S2', 'Function 4, S1'].map((name) => field(name).value)).toEqual([
      '25',
      '25',
      '55',
    ]);
    await press('Undo fill down of 4 values');
    expect(field('Function 3, S2').value).toBe('45');
  });

  it('takes a paste in the same way as by keys, after a preview', async () => {
    await connected();
    clipboard({ readText: async () => '7' });
    await pick('Function 2, S1', 'Function 3, S1');
    await press('Paste…');
    const dialog = within(screen.getByRole('dialog', { name: 'Paste' }));
    expect(dialog.getAllByRole('row').map(({ textContent }) => textContent)).toEqual([
      'FunctionS1',
      'Function 27 35',
      'Function 37 45',
    ]);
  });

  it.each<[what: string, given: Partial<Clipboard>, said: RegExp]>([
    [
      'the browser does not let it',
      { readText: () => Promise.reject(new Error('no')) },
      /Tap the first field and paste/,
    ],
    ['the browser never answers', { readText: () => new Promise(() => {}) }, /Tap the first field and paste/],
    ['there is no clipboard', {}, /Tap the first field and paste/],
    ['nothing was copied', { readText: async () => '' }, new RegExp(en.edits.table.range.clipboardClosed)],
  ])('says what to do when %s', async (_, given, said) => {
    await connected();
    clipboard(given);
    await pick('Function 2, S1', 'Function 3, S1');
    await press('Paste…');
    expect(screen.getByRole('alert').textContent).toMatch(said);
    await press('Done');
    expect(screen.queryByRole('alert')).toBeNull();
  });

  it('takes a paste also when the browser asks the pilot first, and the answer comes late', async () => {
    await connected();
    let allow = (_: string): void => {};
    const asked = new Promise<string>((resolve) => {
      allow = resolve;
    });
    clipboard({ readText: () => asked });
    await pick('Function 2, S1', 'Function 3, S1');
    await press('Paste…');
    expect(screen.getByRole('alert').textContent).toMatch(/Tap the first field and paste/);
    allow('7');
    await idle(0);
    expect([screen.getByRole('dialog', { name: 'Paste' }), screen.queryByRole('alert')]).toEqual([
      expect.anything(),
      null,
    ]);
  });

  it.each<[what: string, given: Partial<Clipboard> | undefined]>([
    ['refuses', { writeText: () => Promise.reject(new DOMException('Not now.', 'NotAllowedError')) }],
    ['never answers', { writeText: () => new Promise(() => {}) }],
    ['is not there', undefined],
  ])('is shown as text to copy by hand when the clipboard %s', async (_, given) => {
    await connected();
    clipboard(given as Clipboard);
    await pick('Function 1 time', 'Function 2, S2');
    await press('Copy');
    const byHand = within(screen.getByRole('dialog', { name: en.copyByHand }));
    expect(byHand.getByRole<HTMLTextAreaElement>('textbox').value).toBe('10.50\t25\t25\n11.00\t35\t35');
    expect(screen.queryByText('Copied.', { exact: true })).toBeNull();
  });

  it('has the same buttons when it was made by keys: Tab goes to them, Escape back to the cell', async () => {
    await connected();
    field('Function 1, S1').focus();
    await key('ArrowDown', { shiftKey: true });
    await key('Tab');
    expect(document.activeElement).toBe(screen.getByRole('button', { name: 'Copy' }));
    await press('Fill down');
    expect(field('Function 2, S1').value).toBe('25');
    await key('Escape');
    expect(document.activeElement).toBe(field('Function 1, S1'));
    expect(marked()).toBe(0);
  });

  it('begins only in the table', async () => {
    await connected();
    await tap(en.program.idleThrottle);
    expect(screen.getByRole('button', { name: 'Done' })).toBeTruthy();
    expect(screen.queryByRole('button', { name: en.edits.sheet.selectRange })).toBeNull();
  });
});
