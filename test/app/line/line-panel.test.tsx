import { act, fireEvent, render, screen, waitFor, within } from '@testing-library/preact';
import { options, type VNode } from 'preact';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { LinePanel } from '../../../src/app/line/line-panel.js';
import { en } from '../../../src/app/messages/en.js';
import { type AppBench, appBench, connectedBench, idle, run } from '../bench/bench.js';
import { button, press } from '../screen.js';
import { damage, lineError } from './line.js';

/** The panel, open, of a pilot who has connected and read. */
async function opened(): Promise<AppBench> {
  return await panelOf(await connectedBench());
}

async function panelOf(bench: AppBench): Promise<AppBench> {
  const { session, models } = bench;
  render(<LinePanel session={session} {...models.line} />);
  return bench;
}

/** As a click on the summary does, in every browser. */
async function unfold(title: string): Promise<void> {
  const details = screen.getByText(title).closest('details') as HTMLDetailsElement;
  details.open = true;
  fireEvent(details, new Event('toggle'));
  await idle();
}

/** Each row as its cells, newest first. */
function rows(): string[][] {
  return within(screen.getByRole('table'))
    .getAllByRole('row')
    .slice(1)
    .map((row) => [...row.children].map(({ textContent }) => textContent.trim()));
}

const messagesShown = (): (string | undefined)[] => rows().map(([, , message]) => message);

function change(label: string, value: string): void {
  fireEvent.change(screen.getByLabelText(label), { target: { value } });
}

function type(label: string, value: string): void {
  fireEvent.input(screen.getByLabelText(label), { target: { value } });
}

async function load(name: string, ...text: string[]): Promise<void> {
  vi.useRealTimers();
  const field = screen.getByLabelText('Load…', { selector: 'input' });
  // A browser lets nobody but the user put files there.
  Object.defineProperty(field, 'files', { value: [new File([text.join('\n')], name)], configurable: true });
  Object.defineProperty(field, 'value', { value: '', writable: true, configurable: true });
  fireEvent.change(field);
}

/** What the page puts into the clipboard, and what it is then. */
function clipboard(writeText: (text: string) => Promise<void> = async () => {}) {
  const spy = vi.fn(writeText);
  vi.spyOn(navigator, 'clipboard', 'get').mockReturnValue({ writeText: spy } as unknown as Clipboard);
  onTestFinished(() => void vi.restoreAllMocks());
  return spy;
}

const RECORDING = [
  '# Sidus capture 1',
  '0.000 > 00 00 00 00 00 03 6b 6b 45',
  '0.052 < 00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45',
  '0.100 < ff fe',
];

describe('the rows', () => {
  it('say when, which way, what it means, and the bytes', async () => {
    await opened();
    const [newest] = rows();
    expect(newest?.[0]).toMatch(/^\d\d:\d\d:\d\d\.\d{3}$/);
    expect(newest?.slice(1)).toEqual([
      en.line.in,
      'Identify, reply · GETSWVER F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos',
      '00 00 00 00 00 0c 6c 51 35 33 36 20 0a 04 03 20 ac 45',
    ]);
    expect(messagesShown()).toContain('Read idle throttle, reply · GETLOWRPM 30, unit unknown');
    expect(messagesShown().at(-2)).toBe(
      'Identify, reply · GETSWVER F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos',
    );
  });

  it('show damage and errors of the line by name', async () => {
    const { session } = await opened();
    session.log.add(damage('checksum', '00 00 00 00 00 03 6b 6c 45'));
    session.log.add(lineError('framing'));
    await idle();
    expect(rows()[0]?.slice(1)).toEqual([
      en.line.in,
      'Line error: framing A byte did not end as it should: the rate is wrong, or the signal is weak.',
      '',
    ]);
    expect(messagesShown()[1]).toMatch(/^Damaged: checksum/);
    expect(screen.getAllByRole('row')[1]?.className).toBe('damaged');
    const counts = screen.getByText('7 to the timer, 7 from the timer, 1 damaged, 1 line error');
    expect(counts.textContent?.split(' '), 'a line ends only between two counts').toHaveLength(4);
  });

  it('stay where they are in the page when new ones come', async () => {
    const { session } = await opened();
    const before = screen.getAllByRole('row').slice(1);
    await run(session.reader.read());
    await idle();
    const after = screen.getAllByRole('row').slice(1);
    expect(after).toHaveLength(before.length + 12);
    expect(after.slice(12)).toEqual(before);
  });
});

describe('many rows', () => {
  /** Frames that are asked for by nobody. */
  async function add(bench: AppBench, count: number): Promise<void> {
    for (let i = 0; i < count; i++) bench.session.log.add(damage('noise', 'ff'));
    await idle();
  }

  it('are drawn only near the visible part, and older ones on a click', async () => {
    await add(await opened(), 100);
    expect(rows()).toHaveLength(32);
    expect(screen.getByText('The newest 32 of 114 are shown.')).toBeTruthy();
    await press('Show older');
    expect(rows()).toHaveLength(64);
    await press('Show older');
    await press('Show older');
    expect(rows()).toHaveLength(114);
    expect(screen.queryByRole('button', { name: 'Show older' })).toBeNull();
  });

  it('are drawn in groups: a new one draws only its own group again', async () => {
    const bench = await opened();
    await add(bench, 80);
    await press('Show older');
    const drawn: unknown[] = [];
    const hooks = options as { __r?: ((vnode: VNode) => void) | undefined };
    const { __r: before } = hooks;
    onTestFinished(() => {
      hooks.__r = before;
    });
    hooks.__r = (vnode) => {
      if (typeof vnode.type === 'function' && ['Group', 'LineRow'].includes(vnode.type.name))
        drawn.push(vnode.type.name);
      before?.(vnode);
    };
    await add(bench, 1);
    expect(drawn).toEqual(['Group', 'LineRow']);
  });
});

describe('on a page without traffic', () => {
  it('it says that nothing was on the line yet, and what can still be done', async () => {
    await panelOf(await appBench());
    expect(screen.getByText(/^Nothing has been on the line yet/)).toBeTruthy();
    expect(screen.getAllByRole('button').map(({ textContent }) => textContent)).toEqual(['Load…', 'Copy report']);
    expect(screen.queryByRole('table')).toBeNull();
  });

  it('a recording is loaded, and another file is refused', async () => {
    await panelOf(await appBench());
    await load('field.txt', 'no recording');
    expect(await screen.findByRole('alert')).toBeTruthy();
    await load('field.txt', ...RECORDING);
    expect(await screen.findByText('field.txt: a recording of 3 entries.')).toBeTruthy();
    expect(rows()).toHaveLength(3);
    expect(button(en.line.replay).disabled).toBe(false);
    fireEvent.click(button(en.line.back));
    expect(await screen.findByText(/^Nothing has been on the line yet/)).toBeTruthy();
  });

  it('a report is copied', async () => {
    const written = clipboard();
    await panelOf(await appBench());
    await press('Copy report');
    expect(written.mock.calls[0]?.[0]).toContain('# Timer: not identified');
  });

  it('the line is shown as soon as there is something on it', async () => {
    const { session } = await panelOf(await appBench());
    await run(session.timer.connect());
    await idle();
    expect(rows()).toHaveLength(14);
    expect(button('Pause')).toBeTruthy();
  });
});

describe('the tools', () => {
  it('stop the list, say how many entries came meanwhile, and go on', async () => {
    const { session } = await opened();
    const before = rows();
    await press('Pause');
    await run(session.reader.read());
    await idle();
    expect(rows()).toEqual(before);
    expect(screen.getByText('Paused. 12 entries since.')).toBeTruthy();
    await press('Go on');
    expect(rows()).toHaveLength(before.length + 12);
    expect(screen.queryByText(/^Paused/)).toBeNull();
  });

  it('empty the log', async () => {
    await opened();
    await press('Clear');
    expect(screen.getByText(en.line.empty)).toBeTruthy();
    expect(button('Save').disabled).toBe(true);
  });

  it('show one kind of entry, and search', async () => {
    await opened();
    change('Show', 'out');
    await idle();
    expect(new Set(rows().map(([, way]) => way))).toEqual(new Set([en.line.out]));
    change('Show', 'all');
    await act(() => type('Search', '6b 6b'));
    await waitFor(() => expect(messagesShown()).toEqual(['Identify · GETSWVER', 'Identify · GETSWVER']));
  });

  it('copy what is shown as a capture', async () => {
    const written = clipboard();
    await opened();
    type('Search', 'GETMEMORY');
    await waitFor(() => expect(new Set(messagesShown()).size).toBe(2));
    await press('Copy');
    expect(screen.getByText('Copied.')).toBeTruthy();
    expect(written.mock.calls[0]?.[0].split('\n').filter((line) => !line.startsWith('# Sidus Timer'))).toEqual([
      '# Sidus capture 1',
      '# Timer: F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos',
      '',
      '# Which memory · GETMEMORY',
      expect.stringMatching(/^0\.000 > 00 00 00 00 00 03 71 71 45$/),
      '# Which memory, reply · GETMEMORY: M1',
      expect.stringMatching(/^0\.\d{3} < 00 00 00 00 00 04 72 00 72 45$/),
      '# Which memory · GETMEMORY',
      expect.stringMatching(/^0\.\d{3} > 00 00 00 00 00 03 71 71 45$/),
      '# Which memory, reply · GETMEMORY: M1',
      expect.stringMatching(/^0\.\d{3} < 00 00 00 00 00 04 72 00 72 45$/),
      '',
    ]);
  });

  it('show the text to be copied by hand where the browser refuses', async () => {
    clipboard(() => Promise.reject(new DOMException('no', 'NotAllowedError')));
    await opened();
    await press('Copy report');
    const area = screen.getByRole<HTMLTextAreaElement>('textbox', { name: /does not let this page copy/ });
    expect(area.value).toMatch(/^# Sidus capture 1\n# Sidus Timer /);
    expect([area.selectionStart, area.selectionEnd]).toEqual([0, area.value.length]);
    await press('Close');
    expect(screen.queryByRole('textbox', { name: /does not let/ })).toBeNull();
  });

  it('save the whole line as a file, whatever is shown of it', async () => {
    const made: Blob[] = [];
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${made.push(blob as Blob)}`);
    vi.spyOn(URL, 'revokeObjectURL').mockImplementation(() => {});
    const clicked: string[] = [];
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
      clicked.push(this.download);
    });
    onTestFinished(() => void vi.restoreAllMocks());
    await opened();
    change('Show', 'damaged');
    await idle();
    await press('Save');
    expect(clicked).toEqual(['sidus-line-Q536.txt']);
    vi.useRealTimers();
    const text = await made[0]?.text();
    expect(text?.split('\n').filter((line) => /^\d/.test(line))).toHaveLength(14);
  });
});

describe('a recording', () => {
  it('is shown in place of the line, and named as a file, until the pilot goes back', async () => {
    await opened();
    const live = rows();
    await load('field.txt', ...RECORDING);
    expect(await screen.findByText('field.txt: a recording of 3 entries.')).toBeTruthy();
    expect(rows().map(([time, way]) => [time, way])).toEqual([
      ['0.100', en.line.in],
      ['0.052', en.line.in],
      ['0.000', en.line.out],
    ]);
    expect(screen.queryByRole('button', { name: 'Pause' })).toBeNull();
    fireEvent.click(button(en.line.back));
    expect(await screen.findByRole('button', { name: 'Pause' })).toBeTruthy();
    expect(rows()).toEqual(live);
  });

  it('is replayed as a timer', async () => {
    const { session } = await opened();
    const tried = vi.spyOn(session.timer, 'tryRecording').mockResolvedValue();
    await load('field.txt', ...RECORDING);
    fireEvent.click(await screen.findByRole('button', { name: en.line.replay }));
    expect(tried.mock.calls[0]?.[0].map(({ time }) => time)).toEqual([0, 52, 100]);
    expect(await screen.findByRole('button', { name: 'Pause' }), 'the live line is shown again').toBeTruthy();
  });

  it('is not offered for replay without the identity of the timer', async () => {
    await opened();
    await load('field.txt', ...RECORDING.slice(0, 2));
    expect(await screen.findByText(/It cannot be replayed/)).toBeTruthy();
    expect(button(en.line.replay).disabled).toBe(true);
  });

  it('is refused with the line that is wrong', async () => {
    await opened();
    await load('field.txt', ...RECORDING, '0.050 < 00');
    expect((await screen.findByRole('alert')).textContent).toContain('Line 5 of this file cannot be read.');
    fireEvent.click(button('Dismiss'));
    await waitFor(() => expect(screen.queryByRole('alert')).toBeNull());
  });

  it('may be dropped on the panel', async () => {
    await opened();
    vi.useRealTimers();
    const drop = new Event('drop', { bubbles: true, cancelable: true });
    const files = [new File([RECORDING.join('\n')], 'dropped.txt')];
    Object.assign(drop, { dataTransfer: { types: ['Files'], files } });
    fireEvent(screen.getByRole('table'), drop);
    expect(await screen.findByText('dropped.txt: a recording of 3 entries.')).toBeTruthy();
    expect(drop.defaultPrevented, 'the browser does not open the file').toBe(true);
  });
});

describe('a frame by hand', () => {
  it('is shown as it goes out, with what it says', async () => {
    await opened();
    await unfold(en.line.send.title);
    change('Frame', 'SETSERVO');
    type(en.line.send.data, '040146');
    await idle();
    expect(screen.getByText(/Goes out as/).textContent).toBe(
      'Goes out as 00 00 00 00 00 06 63 04 01 46 ae 45 Write a position · SETSERVO Function 4, S2: 70 steps',
    );
  });

  it('refuses bad hex at the field', async () => {
    await opened();
    await unfold(en.line.send.title);
    type(en.line.send.data, '0');
    await idle();
    const field = screen.getByLabelText(/^Data, in hex/);
    expect(field.getAttribute('aria-invalid')).toBe('true');
    const said = document.getElementById(field.getAttribute('aria-describedby') ?? '');
    expect(said?.textContent).toBe(en.line.send.faults['odd-digits']);
    expect(button('Send').getAttribute('aria-disabled')).toBe('true');
  });

  it('that only reads is sent at once, and its reply shown', async () => {
    const { timer } = await opened();
    await unfold(en.line.send.title);
    change('Frame', 'GETMEMORY');
    timer.core.memory = 2;
    timer.core.answered.length = 0;
    await idle();
    await press('Send');
    expect(screen.getByText('Answered:').parentElement?.textContent).toBe(
      'Answered: Which memory, reply · GETMEMORY M3',
    );
    expect(timer.core.answered).toHaveLength(1);
  });

  it.each([
    ['SETMEMORY', 'This changes what the timer holds.'],
    ['MOVETOFUNC', 'Servos may move.'],
    ['UNLOCK', 'the propeller may start.'],
    ['JUMP2', 'servos may move, the propeller may start, and what the timer holds may change.'],
  ])('that may do more needs a second click, after a text that says what may happen: %s', async (name, warning) => {
    const { timer } = await opened();
    await unfold(en.line.send.title);
    change('Frame', name);
    type(en.line.send.data, name === 'MOVETOFUNC' || name === 'SETMEMORY' ? '01' : '');
    timer.core.answered.length = 0;
    await idle();
    await press('Send…');
    const asking = screen.getByRole('alertdialog', { name: en.line.send.confirmTitle });
    expect(asking.textContent).toContain(warning);
    expect(document.activeElement, 'no button has the focus, so a key that is held down presses nothing').toBe(asking);
    expect(timer.core.answered).toEqual([]);
    const yes = button(en.line.send.confirm);
    fireEvent.click(yes);
    fireEvent.click(yes);
    await idle();
    expect(timer.core.answered.filter((request) => request.name === name)).toHaveLength(1);
    expect(screen.queryByRole('alertdialog')).toBeNull();
  });

  it.each(['button', 'Escape'])('is cancelled by %s', async (how) => {
    const { timer } = await opened();
    await unfold(en.line.send.title);
    change('Frame', 'UNLOCK');
    await idle();
    await press('Send…');
    timer.core.answered.length = 0;
    if (how === 'button') await press('Do not send');
    else fireEvent.keyDown(screen.getByRole('alertdialog'), { key: 'Escape' });
    await idle();
    expect(screen.queryByRole('alertdialog')).toBeNull();
    expect(document.activeElement).toBe(button('Send…'));
    expect(timer.core.answered).toEqual([]);
  });

  it('can have any letter', async () => {
    await opened();
    await unfold(en.line.send.title);
    change('Frame', 'other');
    await idle();
    type(en.line.send.letter, '7');
    await idle();
    expect(screen.getByText(en.line.send.faults['not-a-byte'])).toBeTruthy();
    type(en.line.send.letter, '79');
    await idle();
    expect(screen.getByText(/Goes out as/).textContent).toContain('03 79 79 45 Unknown letter 79');
  });

  it('that was lost with its adapter may have done what it asks for', async () => {
    const { timer, adapter } = await opened();
    await unfold(en.line.send.title);
    change('Frame', 'UNLOCK');
    await idle();
    await press('Send…');
    timer.core.onAnswer = () => adapter.unplug();
    await press(en.line.send.confirm);
    const sentence = en.line.send.unanswered;
    expect([timer.core.motorLocked, screen.queryByRole('button', { name: 'Send…' })]).toEqual([false, null]);
    expect(screen.getByText(sentence), 'while the adapter is gone').toBeTruthy();
    timer.core.onAnswer = undefined;
    adapter.replug();
    await idle();
    expect(button('Send…')).toBeTruthy();
    expect(screen.getByText(sentence), 'when it is back').toBeTruthy();
  });

  it('is not offered without a connection', async () => {
    const bench = await appBench();
    await run(bench.session.timer.connect());
    await run(bench.session.timer.disconnect());
    await panelOf(bench);
    await unfold(en.line.send.title);
    expect(screen.getByText(en.line.send.notConnected)).toBeTruthy();
    expect(screen.queryByRole('button', { name: /^Send/ })).toBeNull();
  });
});
