import { act, fireEvent, render, screen, waitFor, within } from '@testing-library/preact';
import { options, type VNode } from 'preact';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { LinePanel } from '../../../src/app/line/line-panel.js';
import { en } from '../../tools/en.js';
import { type AppBench, appBench, connectedBench, idle, run } from '../bench/bench.js';
import { button, press } from '../screen.js';
import { damage, lineError } from './line.js';

const words = en.line;

/** The panel, open, of a pilot who has connected and read. */
async function opened(): Promise<AppBench> {
  return await panelOf(await connectedBench());
}

async function panelOf(bench: AppBench): Promise<AppBench> {
  const { session, models } = bench;
  render(<LinePanel session={session} {...models.line} />);
  return bench;
}

function items(): HTMLElement[] {
  return within(screen.getByRole('list', { name: en.views.names.line })).getAllByRole('listitem');
}

/** Each row as its parts, newest first. */
function rows(): string[][] {
  return items().map((row) => [...row.children].map(({ textContent }) => textContent.trim()));
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
  fireEvent.click(button(words.load));
  const field = document.querySelector('input[type=file]') as HTMLInputElement;
  // A browser lets nobody but the user put files there.
  Object.defineProperty(field, 'files', { value: [new File([text.join('\n')], name)] });
  fireEvent.change(field);
}

/** What the page puts into the clipboard, and what it is then. */
function clipboard(writeText: (text: string) => Promise<void> = async () => {}) {
  const spy = vi.fn(writeText);
  vi.spyOn(navigator, 'clipboard', 'get').mockReturnValue({ writeText: spy } as unknown as Clipboard);
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
      words.in,
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
    expect(rows()[0]?.slice(1)).toEqual([words.in, words.error.framing, '']);
    expect(messagesShown()[1]).toBe(words.rejected.checksum);
    expect(items()[0]?.className).toBe('damaged');
    const counts = screen.getByText('7 to the timer, 7 from the timer, 1 damaged, 1 line error');
    expect(counts.textContent?.split(' '), 'a line ends only between two counts').toHaveLength(4);
  });
});

describe('many rows', () => {
  /** Bytes that belong to no frame. */
  async function add(bench: AppBench, count: number): Promise<void> {
    for (let i = 0; i < count; i++) bench.session.log.add(damage('noise', 'ff'));
    await idle();
  }

  it('are drawn as far as a pilot looks, and older ones on a click', async () => {
    await add(await opened(), 200);
    expect(rows()).toHaveLength(100);
    await press(en.showMore({ count: 100 }));
    expect(rows()).toHaveLength(200);
    await press(en.showMore({ count: 14 }));
    expect(rows()).toHaveLength(214);
    expect(screen.queryByRole('button', { name: /more$/ })).toBeNull();
  });

  it('are drawn once: a new one draws no other', async () => {
    const bench = await opened();
    await add(bench, 80);
    const drawn: unknown[] = [];
    const hooks = options as { __r?: ((vnode: VNode) => void) | undefined };
    const { __r: before } = hooks;
    onTestFinished(() => {
      hooks.__r = before;
    });
    hooks.__r = (vnode) => {
      if (typeof vnode.type === 'function' && vnode.type.name === 'LineRow') drawn.push(vnode.type.name);
      before?.(vnode);
    };
    await add(bench, 1);
    expect(drawn).toHaveLength(1);
  });
});

describe('on a page without traffic', () => {
  it('it says that nothing was on the line yet, and what can still be done', async () => {
    await panelOf(await appBench());
    expect(screen.getByText(words.unused)).toBeTruthy();
    expect(screen.getAllByRole('button').map(({ textContent }) => textContent)).toEqual([words.load, words.copyReport]);
    expect(screen.queryByRole('list')).toBeNull();
  });

  it('a recording is loaded, and another file is refused', async () => {
    await panelOf(await appBench());
    await load('field.txt', ...RECORDING);
    expect(await screen.findByText(words.recording({ name: 'field.txt', entries: 3 }))).toBeTruthy();
    await load('other.txt', 'no recording');
    expect((await screen.findByRole('alert')).textContent).toContain(words.noRecording);
    expect(screen.getByText(words.recording({ name: 'field.txt', entries: 3 })), 'the first file stays').toBeTruthy();
    expect(rows()).toHaveLength(3);
    expect(button(words.replay).disabled).toBe(false);
    fireEvent.click(button(words.back));
    expect(await screen.findByText(words.unused)).toBeTruthy();
  });

  it('the line is shown as soon as there is something on it', async () => {
    const { session } = await panelOf(await appBench());
    await run(session.timer.connect());
    await idle();
    expect(rows()).toHaveLength(14);
    expect(button(en.pause)).toBeTruthy();
  });
});

describe('the tools', () => {
  it('stop the list, say how many entries came meanwhile, and go on', async () => {
    const { session } = await opened();
    const before = rows();
    await press(en.pause);
    await run(session.reader.read());
    await idle();
    expect(rows()).toEqual(before);
    expect(screen.getByText(words.came({ number: 12 }))).toBeTruthy();
    await press(words.goOn);
    expect(rows()).toHaveLength(before.length + 12);
    expect(screen.queryByText(/^Paused/)).toBeNull();
  });

  it('empty the log', async () => {
    await opened();
    await press(words.clear);
    expect(screen.getByText(words.empty)).toBeTruthy();
    expect(button('Save').disabled).toBe(true);
  });

  it('show one kind of entry, and search', async () => {
    await opened();
    change(words.filter, 'out');
    await idle();
    expect(new Set(rows().map(([, way]) => way))).toEqual(new Set([words.out]));
    change(words.filter, 'all');
    await act(() => type(en.label.search, '6b 6b'));
    await waitFor(() => expect(messagesShown()).toEqual(['Identify · GETSWVER', 'Identify · GETSWVER']));
  });

  it('copy what is shown as a capture', async () => {
    const written = clipboard();
    await opened();
    type(en.label.search, 'GETMEMORY');
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

  it('save the whole line as a file, whatever is shown of it', async () => {
    const made: Blob[] = [];
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => `blob:${made.push(blob as Blob)}`);
    vi.spyOn(URL, 'revokeObjectURL').mockImplementation(() => {});
    const clicked: string[] = [];
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
      clicked.push(this.download);
    });
    await opened();
    change(words.filter, 'damaged');
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
    expect(await screen.findByText(words.recording({ name: 'field.txt', entries: 3 }))).toBeTruthy();
    expect(rows().map(([time, way]) => [time, way])).toEqual([
      ['0.100', words.in],
      ['0.052', words.in],
      ['0.000', words.out],
    ]);
    expect(screen.queryByRole('button', { name: en.pause })).toBeNull();
    fireEvent.click(button(words.back));
    expect(await screen.findByRole('button', { name: en.pause })).toBeTruthy();
    expect(rows()).toEqual(live);
  });

  it('is replayed as a timer', async () => {
    const { session } = await opened();
    const tried = vi.spyOn(session.timer, 'tryRecording').mockResolvedValue();
    await load('field.txt', ...RECORDING);
    fireEvent.click(await screen.findByRole('button', { name: words.replay }));
    expect(tried.mock.calls[0]?.[0].map(({ time }) => time)).toEqual([0, 52, 100]);
    expect(await screen.findByRole('button', { name: en.pause }), 'the live line is shown again').toBeTruthy();
  });

  it('is not offered for replay without the identity of the timer', async () => {
    await opened();
    await load('field.txt', ...RECORDING.slice(0, 2));
    expect(await screen.findByText(words.cannotReplay)).toBeTruthy();
    expect(button(words.replay).disabled).toBe(true);
  });

  it('is refused with the line that is wrong', async () => {
    await opened();
    await load('field.txt', ...RECORDING, '0.050 < 00');
    expect((await screen.findByRole('alert')).textContent).toContain(words.noRecordingAt({ line: 5 }));
    fireEvent.click(button(en.dismiss));
    await waitFor(() => expect(screen.queryByRole('alert')).toBeNull());
  });
});

describe('a frame by hand', () => {
  const { send } = words;

  async function typed(text: string): Promise<void> {
    type(send.bytes, text);
    await idle();
  }

  it('is shown as it goes out, with what it says', async () => {
    await opened();
    await typed('63040146');
    expect(screen.getByText(/Goes out as/).textContent).toBe(
      'Goes out as 00 00 00 00 00 06 63 04 01 46 ae 45 Write a position · SETSERVO Function 4, S2: 70 steps',
    );
    await typed('79');
    expect(screen.getByText(/Goes out as/).textContent).toContain('03 79 79 45 Unknown letter 79');
  });

  it('refuses bad hex at the field', async () => {
    await opened();
    await typed('0');
    const field = screen.getByLabelText(send.bytes);
    expect(field.getAttribute('aria-invalid')).toBe('true');
    const said = document.getElementById(field.getAttribute('aria-describedby') ?? '');
    expect(said?.textContent).toBe(send.faults.hex);
    expect(button(send.send).disabled).toBe(true);
  });

  it('is sent after a text that says what may happen and a tick that it is safe, and its reply is shown', async () => {
    const { timer } = await opened();
    timer.core.memory = 2;
    await typed('71');
    timer.core.answered.length = 0;
    await press(send.send);
    const dialog = within(screen.getByRole('dialog', { name: send.confirmTitle }));
    expect(dialog.getByText(send.danger)).toBeTruthy();
    expect(button(send.confirm).disabled).toBe(true);
    fireEvent.click(dialog.getByLabelText(en.write.safety));
    await idle();
    const yes = button(send.confirm);
    fireEvent.click(yes);
    fireEvent.click(yes);
    await idle();
    expect(screen.queryByRole('dialog')).toBeNull();
    expect(screen.getByText(send.answered).parentElement?.textContent).toBe(
      'Answered: Which memory, reply · GETMEMORY M3',
    );
    expect(
      timer.core.answered.filter(({ name }) => name === 'GETMEMORY'),
      'once, and twice in the reading',
    ).toHaveLength(3);
  });

  it('that was lost with its adapter may have done what it asks for', async () => {
    const { timer, adapter, session } = await opened();
    session.safety.confirm();
    await typed('6d');
    await press(send.send);
    timer.core.onAnswer = () => adapter.unplug();
    await press(send.confirm);
    expect([timer.core.motorLocked, button(send.send).disabled]).toEqual([false, true]);
    expect(screen.getByText(send.unanswered), 'while the adapter is gone').toBeTruthy();
    timer.core.onAnswer = undefined;
    adapter.replug();
    await idle();
    expect(button(send.send).disabled).toBe(false);
    expect(screen.getByText(send.unanswered), 'when it is back').toBeTruthy();
  });
});
