import { act, fireEvent, screen, within } from '@testing-library/preact';
import { options } from 'preact';
import { describe, expect, it, onTestFinished } from 'vitest';
import { formatTime } from '../../../src/app/editing/units.js';
import { messages } from '../../../src/app/messages/index.js';
import { Theme } from '../../../src/app/settings/theme.js';
import type { ProgramField, TimerProgram } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle } from '../bench/bench.js';
import { connected, late } from '../screen.js';

const S1: ProgramField = { kind: 'position', servo: 0, slot: 4 };

const dtOf = ({ identity }: AppBench['editor']): number => identity.value?.functions ?? 0;
const handle = (name: string): Element => screen.getByRole('slider', { name });
/** The name of what is drawn behind the program. */
const behind = () =>
  document.querySelector('.timeline-panel .overlay path:not(.mark)')
    ? document.querySelector('.timeline-behind')?.textContent
    : undefined;

async function key(name: string, pressed: string): Promise<void> {
  fireEvent.keyDown(handle(name), { key: pressed });
  await idle(100);
  fireEvent.keyUp(handle(name), { key: pressed });
  await idle();
}

/** What is drawn a frame late, or once there is time. */
const soon = <T,>(read: () => T) =>
  expect.poll(async () => {
    await idle(100);
    return read();
  });

describe('the timeline', () => {
  it('shows the program on the screen, with what the timer holds behind it once they differ', async () => {
    const { editor } = await connected();
    expect(handle('DT time').getAttribute('aria-valuetext')).toBe('3:00');
    expect(behind()).toBeUndefined();
    editor.type(S1, '99');
    await expect.poll(() => handle('Function 4, S1').getAttribute('aria-valuenow')).toBe('99');
    expect(behind()).toBe(messages.value.knowledge.held.now);
  });

  it('edits the program, with one undo step for each movement', async () => {
    const { editor } = await connected();
    const before = Number(editor.textOf(S1));
    await key('Function 4, S1', 'ArrowUp');
    await key('Function 4, S1', 'ArrowUp');
    expect(editor.textOf(S1)).toBe(String(before + 2));
    editor.undo();
    expect(editor.textOf(S1)).toBe(String(before + 1));
    editor.undo();
    expect([editor.textOf(S1), editor.dirty.value]).toEqual([String(before), false]);
  });

  it.each<[string, (held: Element) => unknown]>([
    ['is released', (held) => fireEvent.keyUp(held, { key: 'ArrowLeft' })],
    ['goes on', (held) => fireEvent.keyDown(held, { key: 'ArrowLeft' })],
    ['is put back', (held) => fireEvent.keyDown(held, { key: 'Escape' })],
  ])('a movement that %s changes nothing in a program that has come meanwhile', async (_, end) => {
    const { editor } = await connected();
    const dt = () => editor.working.value?.times[dtOf(editor)];
    const held = handle('DT time');
    fireEvent.keyDown(held, { key: 'ArrowLeft' });
    await idle(100);
    expect(dt()).toBe(17900);
    // Another timer of the same kind was plugged in.
    const other = structuredClone(editor.baseline.value as TimerProgram);
    (other.times as number[])[dtOf(editor)] = 9000;
    act(() => {
      editor.clear();
      editor.rebase(other);
    });
    await soon(() => handle('DT time').getAttribute('aria-valuetext')).toBe('1:30');
    end(handle('DT time'));
    await idle();
    expect([dt(), editor.changes.value]).toEqual([9000, []]);
  });

  it('brings that servo to the front whose field has the focus', async () => {
    await connected();
    act(() => screen.getByRole('textbox', { name: 'Function 4, S3' }).focus());
    await soon(() => screen.queryByRole('slider', { name: 'Function 4, S3' })).not.toBeNull();
  });

  it('marks in the table the cell of the handle that has the focus, or that the mouse is over', async () => {
    await connected();
    const marked = () =>
      [...document.querySelectorAll('td.marked input')].map((input) => input.getAttribute('aria-label'));
    expect(marked()).toEqual([]);
    act(() => (handle('Function 4, S1') as SVGElement).focus());
    expect(marked()).toEqual(['Function 4, S1']);
    const picture = screen.getByRole('group', { name: /^Servo positions over time/ });
    const [, x, y] = /translate\((\S+) (\S+)\)/.exec(handle('Function 6 time').getAttribute('transform') ?? '') ?? [];
    const { left, top } = picture.getBoundingClientRect();
    const place = { pointerType: 'mouse', clientX: left + Number(x), clientY: top + Number(y) };
    fireEvent.pointerMove(picture, place);
    await expect.poll(marked).toEqual(['Function 6 time']);
    fireEvent.pointerLeave(picture, place);
    await expect.poll(marked).toEqual(['Function 4, S1']);
  });

  it('draws only the old and the new cell of the table for that', async () => {
    await connected();
    act(() => (handle('Function 4, S1') as SVGElement).focus());
    await idle(100);
    const drawn: string[] = [];
    const before = options.diffed ?? (() => {});
    options.diffed = (vnode) => {
      if (typeof vnode.type === 'function') drawn.push(vnode.type.name);
      before(vnode);
    };
    onTestFinished(() => {
      options.diffed = before;
    });
    act(() => (handle('Function 6, S1') as SVGElement).focus());
    await idle(100);
    expect(drawn.filter((name) => /Row|Cell/.test(name))).toEqual(['ValueCell', 'ValueCell']);
  });

  it.each([
    ['a step later', '3:01 min', () => key('DT time', 'ArrowRight')],
    ['a step earlier', '2:59 min', () => key('DT time', 'ArrowLeft')],
    // Past the end that the flight has had until then.
    ['much later', '5:00 min', ({ editor }: AppBench) => editor.type({ kind: 'time', slot: dtOf(editor) }, '5:00')],
  ])('shows in the preview the mark that is moved %s, and never another one', async (_, clock, move) => {
    const app = await connected();
    act(() => (handle('DT time') as SVGElement).focus());
    const facts = document.querySelector('.preview-facts') as Element;
    await soon(() => facts.textContent).toContain(en.preview.comesDown);
    const removed: Node[] = [];
    const observer = new MutationObserver((records) => removed.push(...records.flatMap((r) => [...r.removedNodes])));
    observer.observe(facts, { subtree: true, childList: true, characterData: true });
    await move(app);
    await soon(() => facts.querySelector('.preview-clock')?.textContent).toBe(clock);
    observer.disconnect();
    expect(
      removed.map(({ textContent }) => textContent),
      'the note that the model comes down stays all the time',
    ).toEqual([]);
  });

  it('is as it was left when the view comes back', async () => {
    const app = await connected();
    const picture = screen.getByRole('group', { name: messages.value.timeline.picture });
    for (let servo = 1; servo < 3; servo++) fireEvent.keyDown(picture, { key: 'ArrowDown' });
    await idle();
    act(() => app.models.views.show('settings'));
    await idle();
    expect(document.querySelector('.timeline-panel')).toBeNull();
    act(() => app.models.views.show('program'));
    await idle();
    expect(handle('Function 4, S3')).toBeTruthy();
  });

  it('shows the model at the same time: that of the selected cell, the pointer, or the played flight', async () => {
    const app = await connected();
    const preview = within(screen.getByRole('region', { name: en.preview.title }));
    const happened = () => document.querySelector('.preview-facts p:last-of-type')?.textContent;
    expect(happened()).toBe('Launch');
    act(() => (handle('Function 6, S1') as SVGElement).focus());
    const time = formatTime(app.editor.working.value?.times[6] ?? 0);
    await soon(happened).toBe(`Function 6 at ${time} s`);
    expect(document.querySelector('.timeline-panel .crosshair')).toBeNull();
    fireEvent.input(preview.getByRole('slider', { name: en.preview.time }), { target: { value: '500' } });
    await idle(0);
    expect(happened()).toBe('DT at 3:00 min');
    expect(document.querySelector('.timeline-panel .crosshair')).toBeTruthy();
  });

  it('stays where the pilot seeks in the preview right after a cell was selected', async () => {
    await connected();
    const preview = within(screen.getByRole('region', { name: en.preview.title }));
    act(() => (handle('Function 6, S1') as SVGElement).focus());
    await late();
    fireEvent.input(preview.getByRole('slider', { name: en.preview.time }), { target: { value: '500' } });
    await idle(1000);
    expect(document.querySelector('.preview-facts p:last-of-type')?.textContent).toBe('DT at 3:00 min');
  });

  it.each([en.preview.play, en.next, en.previous])(
    'begins at the cell that was selected a moment before %s was clicked, as it now is',
    async (name) => {
      const { editor, models } = await connected();
      const { player } = models.programPicture;
      const preview = within(screen.getByRole('region', { name: en.preview.title }));
      const click = async (): Promise<number | null> => {
        await late();
        act(() => void fireEvent.click(preview.getByRole('button', { name })));
        player.pause();
        return player.cursor.value;
      };
      const to = (slot: number) => act(() => (handle(`Function ${slot}, S1`) as SVGElement).focus());
      to(4);
      await idle(1000);
      editor.type({ kind: 'time', slot: 6 }, '13.0');
      editor.type({ kind: 'time', slot: 7 }, '13.5');
      to(6);
      const expected = { [en.preview.play]: 1300, [en.next]: 1350, [en.previous]: 1250 }[name];
      expect(await click()).toBe(expected);
      // What was played or sought stays, and is not taken for a new choice.
      await idle(1000);
      expect([player.cursor.value, player.shown.value]).toEqual([expected, expected]);
    },
  );

  it("uses the pilot's names for the servos", async () => {
    const app = await connected();
    const preview = within(screen.getByRole('region', { name: en.preview.title }));
    const lanes = () => document.querySelector('.lane-names')?.textContent;
    expect(preview.getByText(en.preview.guessed)).toBeTruthy();
    expect(lanes()).toBe('S1S2S3');
    fireEvent.click(preview.getByRole('button', { name: en.preview.nameServos }));
    await idle(0);
    fireEvent.change(preview.getByRole('combobox', { name: 'S3 moves' }), { target: { value: 'other' } });
    await idle(0);
    fireEvent.input(preview.getByRole('textbox', { name: 'Name for what S3 moves' }), { target: { value: ' Flap ' } });
    fireEvent.submit(document.querySelector('.servo-form') as HTMLFormElement);
    await idle(0);
    expect(app.session.servoUses.named.value?.map(({ duty, name }) => [duty, name])).toEqual([
      ['rudder', ''],
      ['tailplane', ''],
      ['other', 'Flap'],
    ]);
    expect(lanes()).toMatch(/^S1RudderS2/);
  });
});

describe('the colours', () => {
  it('follow the system or the choice, are kept, and colour the bars of the browser too', () => {
    const page = document.implementation.createHTMLDocument();
    page.head.innerHTML = '<meta name="theme-color" content="#111111">';
    const dark = Object.assign(new EventTarget(), { matches: true });
    const theme = new Theme();
    const stop = theme.follow(page, dark as MediaQueryList);
    const look = () => [page.documentElement.getAttribute('data-theme'), page.querySelector('meta')?.content];
    expect(look()).toEqual(['dark', '#161c22']);
    theme.choose('sun');
    expect(look()).toEqual(['sun', '#ffffff']);
    expect(new Theme().chosen.value).toBe('sun');
    dark.matches = false;
    dark.dispatchEvent(new Event('change'));
    expect(look()).toEqual(['sun', '#ffffff']);
    theme.choose('system');
    expect(look()).toEqual(['light', '#ffffff']);
    stop();
    dark.matches = true;
    dark.dispatchEvent(new Event('change'));
    expect(look()).toEqual(['light', '#ffffff']);
  });

  it('are chosen on the page', async () => {
    const app = await connected();
    app.models.views.show('settings');
    await idle(0);
    const sun = screen.getByRole<HTMLInputElement>('radio', { name: 'Sun' });
    fireEvent.click(sun);
    await idle(0);
    expect([app.models.theme.chosen.value, sun.checked]).toEqual(['sun', true]);
  });
});
