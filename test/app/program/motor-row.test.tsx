import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { idle } from '../bench/bench.js';
import { button, connected, field, late, press, table, type } from '../screen.js';

/** The names of the rows, as they stand. */
const rows = (): (string | null)[] =>
  table()
    .getAllByRole('rowheader')
    .map((row) => row.querySelector('.row-name')?.textContent ?? null);

/** The name of the row after which the motor stop stands. */
const motorAfter = (): string | null | undefined => rows()[rows().indexOf('Motor stop') - 1];

function put(name: string, text: string): void {
  fireEvent.input(field(name), { target: { value: text } });
}

describe('the motor stop of a Q', () => {
  it('stands after the last row with an earlier time, and the interval below it says from what it counts', async () => {
    await connected();
    for (const [time, row, below, from] of [
      ['0', 'Start', 'Function 1', 'Start'],
      ['10.5', 'Start', 'Function 1', 'Start'],
      ['10.51', 'Function 1', 'Function 2', '1'],
      ['12.25', 'Function 4', 'Function 5', '4'],
      ['14.51', 'Function 9', 'DT', '9'],
      ['3:00.01', 'DT', null, null],
    ] as const) {
      await type(en.program.motorStopTime, time);
      expect([motorAfter(), rows().filter((name) => name === 'Motor stop').length], time).toEqual([row, 1]);
      const said = [...document.querySelectorAll('td.interval .cell-name')];
      expect(said.map((each) => each.textContent)).toEqual(from ? [en.edits.table.countedFrom({ row: from })] : []);
      if (below) expect(said[0]?.closest('td')?.querySelector('input')).toBe(field(`${below} interval`));
    }
  });

  it('is not the time of the start, which is 0', async () => {
    await connected();
    const start = within(table().getByRole('row', { name: /^Start/ }));
    expect(start.getByText('0').closest('td')?.className).toContain('time');
    expect(start.queryByRole('textbox', { name: /time/ })).toBeNull();
  });

  it('stays at its place while a time is typed, and moves when the field is left', async () => {
    await connected();
    field(en.program.motorStopTime).focus();
    for (const text of ['1', '12', '12.2', '12.25']) put(en.program.motorStopTime, text);
    await idle();
    expect([motorAfter(), document.activeElement]).toEqual(['Start', field(en.program.motorStopTime)]);
    // On to the next row, as it stands.
    fireEvent.keyDown(field(en.program.motorStopTime), { key: 'Enter' });
    await idle();
    expect([motorAfter(), document.activeElement]).toEqual(['Function 4', field('Function 1 time')]);
    put('Function 1 time', '12.4');
    await idle();
    expect(motorAfter()).toBe('Function 4');
    field('Function 1 time').blur();
    await idle();
    expect(motorAfter()).toBe('Start');
  });

  it('moves at once when a time changes elsewhere', async () => {
    const { editor } = await connected();
    editor.type({ kind: 'time', slot: 0 }, '11.2');
    await idle();
    expect(motorAfter()).toBe('Function 2');
  });

  it('is put back by the tools of its row', async () => {
    await connected();
    await type(en.program.motorStopTime, '12.25');
    await press('Tools for Motor stop');
    await press('Put back Motor stop');
    button('Tools for Motor stop').blur();
    await idle();
    expect([field(en.program.motorStopTime).value, motorAfter()]).toEqual(['10.0', 'Start']);
  });
});

describe('the tools of a row', () => {
  const times = (...names: string[]): string[] => names.map((name) => field(`${name} time`).value);

  it('shift everything after the motor stop with it, again and again, and say how far', async () => {
    await connected();
    await type(en.program.motorStopTime, '12.25');
    await press('Tools for Motor stop');
    const panel = within(screen.getByRole('form', { name: 'Motor stop and all after' }));
    expect(document.activeElement).toBe(panel.getByRole('textbox'));
    expect(panel.getByRole('status').textContent).toBe('Motor stop, functions 5 to 9');
    put(en.edits.shift.by, '0,3');
    // Enter in the field.
    fireEvent.submit(field(en.edits.shift.by).closest('form') as HTMLFormElement);
    await idle();
    expect(panel.getByRole('status').textContent).toBe('Moved 0.30 s later');
    await press('Later');
    expect(panel.getByRole('status').textContent).toBe('Moved 0.60 s later');
    expect(times('Function 4', 'Motor stop', 'Function 5', 'DT')).toEqual(['12.00', '12.85', '13.10', '3:00']);
    await press('Earlier');
    await press(/^Undo shift from/);
    expect(panel.getByRole('status').textContent).toBe('Moved 0.60 s later');
    for (let step = 0; step < 2; step++) await press('Earlier');
    expect(times('Motor stop', 'Function 5')).toEqual(['12.25', '12.50']);
    expect(panel.getByRole('status').textContent).toBe('Motor stop, functions 5 to 9');
    fireEvent.click(screen.getByRole('checkbox', { name: 'Move DT too' }));
    await idle();
    expect(panel.getByRole('status').textContent).toBe('Motor stop, functions 5 to 9, DT');
    await press('Earlier');
    expect(panel.getByRole('status').textContent).toBe('Moved 0.30 s earlier');
  });

  it('stay open and keep the focus when the motor stop passes a function', async () => {
    await connected();
    await type(en.program.motorStopTime, '12.25');
    await press('Tools for Motor stop');
    put(en.edits.shift.by, '1');
    await press('Earlier');
    expect(times('Motor stop')).toEqual(['11.25']);
    expect([motorAfter(), document.activeElement]).toEqual(['Function 4', field(en.edits.shift.by)]);
    fireEvent.keyDown(field(en.edits.shift.by), { key: 'Escape' });
    await idle();
    expect([screen.queryByRole('form'), document.activeElement]).toEqual([null, button('Tools for Motor stop')]);
    field('Function 9, S3').focus();
    await idle();
    expect(motorAfter()).toBe('Function 2');
  });

  it('say why nothing was moved', async () => {
    const { editor } = await connected();
    await press('Tools for Function 2');
    put(en.edits.shift.by, '11.01');
    await press('Earlier');
    expect(screen.getByRole('alert').textContent).toMatch(/^Nothing was changed\. .*This would be before launch\.$/);
    put(en.edits.shift.by, 'soon');
    await idle();
    expect(screen.queryByRole('alert'), 'the message is gone once another value is typed').toBeNull();
    await press('Later');
    expect(screen.getByRole('alert').textContent).toMatch(/^Not a time/);
    expect(editor.dirty.value).toBe(false);
  });

  it.each([
    ['Function 7, S2', 'Function 7'],
    ['DT time', 'DT'],
    ['Start, S1', 'Motor stop'],
    ['Motor stop time', 'Motor stop'],
  ])('are opened by Shift… for the selected row: at %s those of %s', async (name, row) => {
    await connected();
    field(name).focus();
    await press('Shift…');
    const [panel] = screen.getAllByRole('form');
    expect(panel?.closest('tr')?.querySelector('.row-name')?.textContent).toBe(row);
  });

  it('are opened by Shift… without a selected row: at the motor stop, and without one at function 1', async () => {
    await connected({ identity: { timerClass: 'B' } });
    await press('Shift…');
    expect(screen.getByRole('form', { name: 'Function 1 and all after' })).toBeTruthy();
  });

  it('keep their setting from row to row, and close with a press elsewhere', async () => {
    await connected();
    await press('Tools for Function 2');
    put(en.edits.shift.by, '2');
    fireEvent.pointerDown(field('Function 5, S1'));
    await idle();
    expect(screen.queryByRole('form')).toBeNull();
    await press('Tools for Function 7');
    expect(field(en.edits.shift.by).value).toBe('2');
  });

  it('move DT alone from its own row', async () => {
    await connected();
    await press('Tools for DT');
    expect(screen.queryByRole('checkbox', { name: 'Move DT too' })).toBeNull();
    await press('Later');
    expect(times('Function 9', 'DT')).toEqual(['14.50', '3:00.10']);
  });

  it('do not exist at a start where nothing differs', async () => {
    await connected();
    expect(screen.queryByRole('button', { name: 'Tools for Start' })).toBeNull();
    await type('Start, S1', '16');
    await press('Tools for Start');
    expect(screen.queryByRole('textbox', { name: en.edits.shift.by })).toBeNull();
    await press('Put back Start');
    expect(field('Start, S1').value).toBe('15');
  });
});

describe('the old value in a cell', () => {
  it('is struck through beside the new one, and a click on it puts it back in the field with the focus', async () => {
    await connected();
    await type('Function 2, S1', '70');
    const cell = field('Function 2, S1').closest('td') as HTMLElement;
    expect(cell.querySelector('s')?.textContent).toBe('35');
    expect(
      within(cell).queryByRole('button'),
      'the old value is no button, so a click into the field puts nothing back',
    ).toBeNull();
    field('Function 2, S1').focus();
    await idle();
    fireEvent.click(within(cell).getByRole('button', { name: 'Put Function 2, S1 back to 35' }));
    await idle();
    expect([field('Function 2, S1').value, document.activeElement]).toEqual(['35', field('Function 2, S1')]);
    await late();
    expect(cell.querySelector('s')).toBeNull();
  });
});
