import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { CAPTURED_POSITIONS } from '../../protocol/vectors.js';
import { en } from '../../tools/en.js';
import { appBench, idle, MemoryStore } from '../bench/bench.js';
import { button, connected, field, goTo, opened, press, startWrite, table, type } from '../screen.js';

/** What is said about a field to someone who cannot see it. */
function described(name: string): string {
  const ids = field(name).getAttribute('aria-describedby')?.split(' ') ?? [];
  return ids.map((id) => document.getElementById(id)?.textContent).join(' ');
}

describe('the start', () => {
  it('offers Connect, a new program and the simulated timers, but not the line or the settings', async () => {
    await opened();
    expect(screen.getAllByRole('button').map(({ textContent }) => textContent)).toEqual([
      'Connect',
      'F1Q',
      'F1B',
      'F1E',
      en.newProgram.title,
    ]);
    expect(screen.queryByRole('navigation')).toBeNull();
  });

  it('says which browsers work when this one does not, and still offers the simulated timers', async () => {
    await opened({ webSerial: false });
    expect(screen.getByText(en.connection.unsupported.title)).toBeTruthy();
    expect(screen.queryByRole('button', { name: 'Connect' })).toBeNull();
    await press('Try a simulated F1B timer');
    expect(field('DT time').value).toBe('3:00');
  });

  it('says that nothing was chosen, until that is dismissed', async () => {
    const { serial, port } = await opened();
    serial.choose(null);
    await press('Connect');
    expect(screen.getByText(en.connection['nothing-chosen'].title)).toBeTruthy();
    await press('Dismiss');
    expect(screen.queryByText(en.connection['nothing-chosen'].title)).toBeNull();
    serial.choose(port);
    await press('Connect');
    expect(field('DT time').value).toBe('3:00');
  });

  it('does not say that another program holds the port while it tries again, or when the adapter has failed', async () => {
    const { port } = await opened();
    port.open = () => Promise.reject(new DOMException('The device is broken.', 'UnknownError'));
    fireEvent.click(button('Connect'));
    await idle(5000);
    expect(screen.getByText(en.link.refused)).toBeTruthy();
    await idle();
    expect(screen.getByText(en.connection.busy.title)).toBeTruthy();
    expect(screen.queryByText(/in use/)).toBeNull();
  });

  it('says that a port cannot be opened, with what helps, and offers another by one button', async () => {
    const { port } = await opened();
    port.device.busy = true;
    await press('Connect');
    expect(screen.getByText(en.connection.busy.title)).toBeTruthy();
    expect(
      screen.queryByText(/in use/),
      'the browser does not say that the port is in use, so the page must not',
    ).toBeNull();
    expect(screen.getAllByRole('button', { name: /Choose|Another/ })).toHaveLength(1);
    port.device.busy = false;
    await press(en.header.choosePort);
    expect(screen.queryByText(en.connection.busy.title)).toBeNull();
    expect(field('DT time').value).toBe('3:00');
  });
});

describe('the table', () => {
  it('shows start to DT with the positions of the capture', async () => {
    await connected();
    const rows = table()
      .getAllByRole('rowheader')
      .map(({ textContent }) => textContent);
    const functions = Array.from({ length: 9 }, (_, i) => `Function ${i + 1}`);
    expect(rows.map((row) => row?.trim())).toEqual([
      'Start',
      'Motor stop',
      ...functions,
      'DT min',
      en.program.idleThrottle,
    ]);
    for (const servo of ['S1', 'S2', 'S3']) {
      expect(['Start', ...functions, 'DT'].map((row) => field(`${row}, ${servo}`).value)).toEqual(
        CAPTURED_POSITIONS.map(String),
      );
    }
    expect(field('Function 1 time').value).toBe('10.50');
    expect(field('DT time').value).toBe('3:00');
  });

  it('has as many rows and columns as the timer says', async () => {
    await connected({ identity: { timerClass: 'Q', functions: 3, servos: 4, memories: 2 } });
    expect(table().getAllByRole('rowheader')).toHaveLength(6);
    expect(
      table()
        .getAllByRole('columnheader')
        .map(({ textContent }) => textContent),
    ).toEqual([`Function${en.edits.table.explain}`, 'Time s', 'After s', 'S1', 'S2', 'S3', 'S4']);
    expect(screen.getAllByRole('radio', { name: /^M\d/ })).toHaveLength(2);
  });

  it('marks what differs, with the old value', async () => {
    await connected();
    await type('Function 2, S1', '70');
    expect(screen.getByText('was 35')).toBeTruthy();
    expect(described('Function 2, S1')).toBe('was 35');
    expect(screen.getByText('1 change')).toBeTruthy();
    await type('Function 2, S1', '35');
    expect(screen.queryByText('was 35')).toBeNull();
    expect(screen.getByText(/^As in the timer, read \d\d:\d\d$/)).toBeTruthy();
  });

  it.each([
    ['Function 2, S1', '131', en.findings['position-out-of-range']({ min: '0', max: '130' })],
    ['Function 2, S1', '-1', en.findings['position-out-of-range']({ min: '0', max: '130' })],
    ['Function 2, S1', 'six', en.unreadable['not-a-whole-number']],
    ['Function 2, S1', '1.5', en.unreadable['not-a-whole-number']],
    ['Function 2, S1', '', 'Empty: type a value.'],
    ['DT time', '10:55.36', en.findings['time-out-of-range']({ min: '0.00\u00a0s', max: '10:55.35\u00a0min' })],
    ['DT time', '999999', en.findings['time-out-of-range']({ min: '0.00\u00a0s', max: '10:55.35\u00a0min' })],
    ['DT time', 'soon', 'Not a time: type seconds like 12.5, or minutes like 2:05.'],
    ['DT time', '1.234', 'Finer than a hundredth of a second.'],
    ['DT time', '', 'Empty: type a value.'],
    [en.program.idleThrottle, '256', en.findings['throttle-out-of-range']({ min: '0', max: '255' })],
  ])('refuses %s = %j at the field with a reason, and nothing can be written', async (name, text, reason) => {
    const { write, timer } = await connected();
    timer.core.answered.length = 0;
    await type(name, text);
    expect(field(name).value, 'the field keeps the text; a time is shown in minutes').toBe(
      text === '999999' ? '16666:39' : text,
    );
    expect(field(name).getAttribute('aria-invalid')).toBe('true');
    expect(described(name)).toContain(reason);
    const said = name === 'DT time' ? 'DT' : name;
    expect(table().getAllByText(`${said}:`)[0]?.parentElement?.textContent).toBe(`${said}: ${reason}`);
    const why = document.getElementById(button('Write…').getAttribute('aria-describedby') ?? '');
    expect(why?.textContent).toBe(`Nothing can be written yet. ${said}: ${reason}`);
    await press('Write…');
    expect([write.current.value, timer.core.answered]).toEqual([null, []]);
    // It leads to its cause.
    expect(document.activeElement).toBe(field(name));
  });

  it('leads from Write to the first field that blocks it, then to the next, and at last to the difference', async () => {
    const { write } = await connected();
    await type('Function 2, S1', '131');
    await type('DT time', '2.30');
    await press('Write…');
    expect(document.activeElement).toBe(field('DT time'));
    fireEvent.click(screen.getAllByRole('button', { name: '2 min 30 s' })[0] as HTMLElement);
    await idle();
    await press('Write…');
    expect([document.activeElement, write.current.value]).toEqual([field('Function 2, S1'), null]);
    await type('Function 2, S1', '130');
    expect(button('Write…').getAttribute('aria-describedby')).toBeNull();
    await press('Write…');
    expect(write.current.value).not.toBeNull();
  });

  it('says one reason for each field that has it', async () => {
    await connected();
    for (const servo of ['S1', 'S2', 'S3']) await type(`Function 2, ${servo}`, '131');
    const reasons = () => table().getAllByText(/^Function 2, S.:$/);
    expect(reasons()).toHaveLength(3);
    await type('Function 2, S2', '130');
    expect(reasons().map(({ textContent }) => textContent)).toEqual(['Function 2, S1:', 'Function 2, S3:']);
  });

  it('puts everything back with Undo all, which is shown only when there is something to undo', async () => {
    await connected();
    expect(screen.queryByRole('button', { name: 'Undo all' })).toBeNull();
    await type('DT time', 'soon');
    await type('Function 2, S1', '7');
    await press('Undo all');
    expect([field('DT time').value, field('Function 2, S1').value]).toEqual(['3:00', '35']);
    expect(document.activeElement?.textContent, 'where it can be taken back').toBe('Undo');
  });

  it('leaves the focus on Undo and Redo when no step is left', async () => {
    await connected();
    await type('Function 2, S1', '7');
    for (const [name, left] of [
      ['Undo', '35'],
      ['Redo', '7'],
    ] as const) {
      const step = button(`${name} change of function 2, S1`);
      step.focus();
      await press(`${name} change of function 2, S1`);
      await press(name);
      expect(field('Function 2, S1').value).toBe(left);
      expect(document.activeElement).toBe(step);
      expect([step.disabled, step.getAttribute('aria-disabled')]).toEqual([false, 'true']);
    }
  });
});

describe('the table of each class', () => {
  it('has a DT that the strip shows, too: in red when it is short', async () => {
    await connected();
    await type('DT time', '30');
    expect(field('DT time').value).toBe('30.00');
    expect(screen.getAllByText('Short DT')[0]?.closest('.strip-figure.bad')).toBeTruthy();
  });

  it.each(['B', 'E'])(
    'shows no motor stop on %s, and what the start holds only when it is not 0',
    async (timerClass) => {
      const { editor } = await connected({ identity: { timerClass } });
      expect(screen.queryByRole('textbox', { name: en.program.motorStopTime })).toBeNull();
      expect(screen.queryByRole('textbox', { name: 'Start time' })).toBeNull();
      const start = document.querySelector('tr[data-slot="0"] td.time') as HTMLElement;
      const set = async (value: number): Promise<string | null> => {
        editor.apply(setValues({ code: 'change', params: {} }, [{ field: { kind: 'time', slot: 0 }, value }]));
        await idle();
        return start.textContent?.trim();
      };
      expect([await set(0), await set(1234)]).toEqual([
        '0',
        `${en.program.reserved({ time: en.seconds({ time: '12.34' }) })} 0`,
      ]);
    },
  );

  it('shows the idle throttle only when the timer has said one', async () => {
    await connected({ identity: { timerClass: 'B' } });
    expect(screen.queryByRole('textbox', { name: en.program.idleThrottle })).toBeNull();
  });
});

describe('writing', () => {
  it('shows the difference, asks for the safety, and says verified', async () => {
    const { timer } = await connected();
    await type('DT time', '4:00');
    await type('Function 2, S1', '7');
    await press('Write…');
    const dialog = within(screen.getByRole('dialog', { name: en.write.title }));
    const rows = dialog.getAllByRole('row').map((row) => [...row.children].map(({ textContent }) => textContent));
    expect(rows).toEqual([
      ['Value', 'Timer holds', 'Will hold'],
      ['DT', '3:00 min', '4:00 min'],
      ['Function 2, S1', '35', '7'],
    ]);
    expect(button('Write 2 changes').disabled).toBe(true);
    fireEvent.click(dialog.getByRole('checkbox', { name: /^The propeller is off/ }));
    await press('Write 2 changes');
    const said = dialog.getByRole('alert').textContent;
    expect(said).toContain('Verified.');
    expect(said).toMatch(/M1\sverified\s\d\d:\d\d\s· DT\s4:00\smin\s· motor\sstop\s10\.0\ss\s· 2\schanges/);
    expect([timer.core.content.times[10], timer.core.content.positions[0]?.[2]]).toEqual([24000, 7]);
    const shining = () =>
      [...document.querySelectorAll('td .confirmed input')].map((input) => input.getAttribute('aria-label'));
    expect(shining(), 'the confirmed fields are marked as long as the result is shown').toEqual([
      'Function 2, S1',
      'DT time',
    ]);
    await press('Close');
    expect(shining()).toEqual([]);
    expect(screen.queryByRole('dialog')).toBeNull();
    expect(screen.getByText(/^As in the timer, verified \d\d:\d\d$/)).toBeTruthy();
  });

  it('keeps the focus in the dialog from step to step', async () => {
    await connected();
    await type('Function 2, S1', '7');
    await press('Write…');
    const dialog = screen.getByRole('dialog', { name: en.write.title });
    fireEvent.click(within(dialog).getByRole('checkbox', { name: /^The propeller is off/ }));
    await idle();
    button('Write 1 change').focus();
    await press('Write 1 change');
    expect(within(dialog).getByRole('alert').textContent).toContain('Verified.');
    expect(dialog.contains(document.activeElement)).toBe(true);
  });

  it('asks for a tick when something is serious', async () => {
    await connected();
    await type('Motor stop time', '4:00');
    await press('Write…');
    const { stillToTick, ticks } = en.write;
    const why = () => document.getElementById(button('Write 1 change').getAttribute('aria-describedby') ?? '');
    expect(why()?.textContent).toBe(stillToTick({ ticks: `${ticks.warnings}, ${ticks.safety}` }));
    fireEvent.click(screen.getByRole('checkbox', { name: en.write.safety }));
    await idle();
    expect(why()?.textContent).toBe(stillToTick({ ticks: ticks.warnings }));
    expect(button('Write 1 change').disabled).toBe(true);
    const dialog = screen.getByRole('dialog');
    const finding = within(dialog).getByText(/The motor stops after DT \(3:00\smin\)/);
    const table = within(dialog).getByRole('table');
    expect(finding.compareDocumentPosition(table), 'above the table').toBe(Node.DOCUMENT_POSITION_FOLLOWING);
    fireEvent.click(screen.getByRole('checkbox', { name: en.write.acknowledge }));
    await idle();
    expect([button('Write 1 change').disabled, why()]).toEqual([false, null]);
  });

  it('names a short DT above the table, and needs no tick for it', async () => {
    await connected();
    await type('DT time', '15');
    await press('Write…');
    const [dt] = screen.getByRole('dialog').querySelectorAll('.key-figures > span');
    expect(dt?.textContent).toContain(en.program.shortDt);
    fireEvent.click(screen.getByRole('checkbox', { name: en.write.safety }));
    await idle();
    expect(button('Write 1 change').disabled).toBe(false);
  });

  it('shows what the timer holds when it did not take a value', async () => {
    await connected({ quirks: { servoNeedsMove: true } });
    await type('Function 2, S1', '7');
    await press('Write…');
    await startWrite();
    const dialog = within(screen.getByRole('dialog'));
    expect(dialog.getByRole('alert').textContent).toContain(en.write.differs.title);
    expect(dialog.getByRole('row', { name: /Function 2, S1/ }).textContent).toMatch(/7\s*35\s*differs/);
  });

  it('offers to move the servos once it is known that positions need it, and moves them only then', async () => {
    const { timer } = await connected({ quirks: { servoNeedsMove: true } });
    const move = () => screen.queryByRole<HTMLInputElement>('checkbox', { name: /^Move the servos to each function/ });
    await type('Function 2, S1', '7');
    await press('Write…');
    expect(move(), 'it is not known yet that positions need a move').toBeNull();
    await startWrite();
    expect(screen.getByRole('alert').textContent).toContain(en.write.move.notHeld.title);
    await press(en.write.move.again);
    expect(move()?.checked).toBe(false);
    expect(move()?.labels?.[0]?.textContent, 'the label itself says how').toMatch(/Hold the model safely/);
    expect(screen.getByText(/will probably not keep these/)).toBeTruthy();
    fireEvent.click(move() as HTMLElement);
    await press('Write 1 change');
    expect(screen.getByRole('alert').textContent).toContain('Verified.');
    expect(screen.queryByRole('button', { name: en.write.move.again })).toBeNull();
    expect(timer.core.content.positions[0]?.[2]).toBe(7);
    await press('Close');
    await type('DT time', '4:00');
    await press('Write…');
    expect(move(), 'no position has changed, so there is no offer to move').toBeNull();
  });

  it('can be cancelled without a trace', async () => {
    const { timer } = await connected();
    await type('DT time', '4:00');
    const { times } = timer.core.content;
    await press('Write…');
    await press('Cancel');
    expect(screen.queryByRole('dialog')).toBeNull();
    expect(timer.core.answered.map(({ name }) => name).filter((name) => name.startsWith('SET'))).toEqual([]);
    expect(timer.core.content.times).toEqual(times);
    expect(field('DT time').value).toBe('4:00');
  });
});

describe('the line', () => {
  it('is a separate view, and keeps what was chosen in it', async () => {
    await connected();
    await goTo('line');
    fireEvent.input(screen.getByRole('searchbox'), { target: { value: 'GETSERVO' } });
    await goTo('program');
    table();
    await goTo('line');
    expect(screen.getByRole<HTMLInputElement>('searchbox').value).toBe('GETSERVO');
  });
});

describe('after a loss', () => {
  it('says that the adapter is unplugged, keeps the edits, and connects again when it comes back', async () => {
    const { adapter, timer } = await connected({ plug: { granted: true } });
    await type('DT time', '4:00');
    adapter.unplug();
    await idle();
    expect(screen.getByText(en.link.lost.title)).toBeTruthy();
    expect([button('Write…').disabled, button('Read again').disabled]).toEqual([true, true]);
    expect(field('DT time').value).toBe('4:00');
    // As one that the browser does not recognise.
    adapter.returnAsNew();
    await idle();
    expect(screen.queryByText(en.link.lost.title)).toBeNull();
    expect(field('DT time').value).toBe('4:00');
    await press('Write…');
    await startWrite();
    expect(within(screen.getByRole('dialog')).getByRole('alert').textContent).toContain('Verified.');
    expect(timer.core.content.times[10]).toBe(24000);
  });

  it('says that the connection is lost whether or not the adapter is still plugged in, and tries again', async () => {
    const { adapter, port } = await connected();
    port.device.error('lost');
    await idle(100);
    expect(screen.getByText(en.link.lost.title)).toBeTruthy();
    expect(screen.getByText(en.link.status.away)).toBeTruthy();
    await idle();
    expect(screen.queryByText(en.link.lost.title)).toBeNull();
    port.device.error('lost');
    await idle(100);
    adapter.unplug();
    await idle();
    expect(screen.getByText(en.link.lost.title)).toBeTruthy();
  });
});

describe('edits of the simulated timer, without Web Serial', () => {
  it.each([
    ['the start', [en.header.closeProgram, en.start.simulated({ name: 'F1Q' }), 'Write…']],
    ['Connect and write', [en.program.connectAndWrite]],
  ])('can be written to it after a reload, by way of %s', async (_, presses) => {
    const store = new MemoryStore();
    const before = await appBench({ store, webSerial: false });
    const trying = before.session.timer.trySimulated('Q');
    await idle();
    await trying;
    before.editor.type({ kind: 'time', slot: 10 }, '4:00');
    await idle();
    await opened({ store, webSerial: false });
    for (const name of presses) {
      expect(screen.queryByRole<HTMLInputElement>('textbox', { name: 'DT time' })?.value ?? '4:00').toBe('4:00');
      await press(name);
    }
    expect(screen.getByRole('dialog', { name: en.write.title }).textContent).toContain('4:00');
    expect(screen.getByText(en.write.safety)).toBeTruthy();
  });
});

it('an idle throttle that could not be read is not known', async () => {
  await connected({ quirks: { idleThrottleLength3: true } });
  const row = screen.getByRole('rowheader', { name: en.program.idleThrottle }).closest('tr') as HTMLElement;
  expect(row.textContent).toContain(en.write.status.unknown);
  expect(within(row).queryByRole('textbox')).toBeNull();
});
