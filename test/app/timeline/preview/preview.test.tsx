import { signal } from '@preact/signals';
import { act, fireEvent, render, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { FlightPreview, type FlightPreviewProps } from '../../../../src/app/timeline/preview/flight-preview.js';
import { Player } from '../../../../src/app/timeline/preview/player.js';
import { guessedUses } from '../../../../src/app/timeline/preview/surfaces.js';
import type { ServoUse } from '../../../../src/program/index.js';
import { en } from '../../../tools/en.js';
import { programOf } from '../../programs.js';
import { HandFrames } from './hand-frames.js';

const PROGRAM = programOf(
  'Q',
  [1000, 200, 400, 600, 18000],
  [
    [65, 130, 0, 65, 65],
    [65, 65, 65, 65, 130],
    [0, 0, 0, 0, 0],
  ],
);

/** A preview, and the frames that play it. */
function shown(props: Partial<FlightPreviewProps> = {}) {
  const frames = new HandFrames();
  const asked = signal<number | null>(null);
  const player = new Player(asked);
  player.setEnd(18300);
  const { unmount } = render(
    <FlightPreview program={PROGRAM} player={player} named={null} onName={() => {}} {...props} />,
  );
  /** So many frames of 100 ms. */
  const run = (count: number) => act(() => frames.run(count, 100));
  return { player, asked, run, unmount };
}

const press = (name: string | RegExp) => act(() => void fireEvent.click(screen.getByRole('button', { name })));
const seek = (player: Player, time: number) => act(() => player.seek(time));
const said = () => screen.getByRole('status').textContent;
const clock = () => document.querySelector('.preview-clock')?.textContent;
/** The line below the clock that says what has happened. */
const happened = () => document.querySelector('.preview-facts p:last-of-type') as HTMLElement;
const stands = () => [...document.querySelectorAll('.preview li')].map((item) => item.textContent);
const turned = (surface: string) => document.querySelector<SVGElement>(`[data-surface=${surface}]`)?.style.transform;

describe('the flight preview', () => {
  it('plays only on a click, then pauses and goes on', async () => {
    const { run } = shown();
    await run(5);
    expect(clock()).toBe('0.00 s');
    await press('Play');
    await run(11);
    expect(clock()).toBe('1.00 s');
    await press('Pause');
    await run(5);
    expect(clock()).toBe('1.00 s');
    expect(screen.getByRole('button', { name: 'Play' })).toBeTruthy();
  });

  it('plays as fast as chosen', async () => {
    const { player, run } = shown();
    const speed = screen.getByRole<HTMLSelectElement>('combobox', { name: 'Speed' });
    await act(() => void fireEvent.change(speed, { target: { value: '20' } }));
    expect(player.speed.value).toBe(20);
    await press('Play');
    await run(11);
    expect(clock()).toBe('20.00 s');
  });

  it('says what has happened, once when it happens', async () => {
    const { player, run } = shown();
    expect(screen.queryByRole('status'), 'a selected cell is not announced').toBeNull();
    await press('Play');
    const heard: (string | null)[] = [said()];
    new MutationObserver(() => heard.push(said())).observe(screen.getByRole('status'), {
      childList: true,
      characterData: true,
      subtree: true,
    });
    for (let second = 0; second < 5; second++) await run(10);
    await seek(player, 1000);
    await seek(player, 18100);
    await act(() => Promise.resolve());
    expect(heard).toEqual([
      'Launch',
      'Function 1 at 2.00 s',
      'Function 2 at 4.00 s',
      'Motor stop at 10.00 s',
      'DT at 3:00 min',
    ]);
  });

  it('says that it does not know when times fall', async () => {
    const { player } = shown({ program: programOf('Q', [1000, 500, 200, 600, 18000]) });
    await seek(player, 300);
    expect(said()).toBe(en.timeline.notKnown);
  });

  it('goes from event to event', async () => {
    shown();
    const seen: (string | null)[] = [];
    for (const name of [en.next, en.next, en.next, en.next, en.previous, en.previous]) {
      await press(name);
      seen.push(said());
    }
    expect(seen).toEqual([
      'Function 1 at 2.00 s',
      'Function 2 at 4.00 s',
      'Function 3 at 6.00 s',
      'Motor stop at 10.00 s',
      'Function 3 at 6.00 s',
      'Function 2 at 4.00 s',
    ]);
  });

  it('can be dragged from launch to the end, and says where it is', async () => {
    const { player } = shown();
    const slider = screen.getByRole<HTMLInputElement>('slider', { name: en.preview.time });
    await act(() => void fireEvent.input(slider, { target: { value: slider.max } }));
    expect(player.cursor.value).toBe(18300);
    expect(slider.getAttribute('aria-valuetext')).toBe('3:03 min');
    await act(() => void fireEvent.input(slider, { target: { value: '0' } }));
    expect(player.cursor.value).toBe(0);
  });

  it('turns each surface as its servo stands, and says its position', async () => {
    const { player } = shown();
    expect([turned('rudder'), turned('tailplane'), turned('wing')]).toEqual([
      'rotate(0deg)',
      'rotate(0deg)',
      'rotate(0deg)',
    ]);
    await seek(player, 200);
    expect(turned('rudder'), 'the rudder is turned to the right').toBe('rotate(-28deg)');
    expect(stands()).toEqual(['S1 Rudder 130', 'S2 Tailplane 65', 'S3 Wing 0']);
    await seek(player, 400);
    expect(turned('rudder'), 'the rudder is turned to the left').toBe('rotate(28deg)');
  });

  it('shows the selected cell, and moves without the pilot only when it is played', async () => {
    const { player, asked } = shown();
    await act(() => player.take(600));
    expect([clock(), happened().textContent, happened().getAttribute('role')]).toEqual([
      '6.00 s',
      'Function 3 at 6.00 s',
      null,
    ]);
    await act(() => {
      asked.value = 200;
    });
    expect(clock()).toBe('2.00 s');
  });

  it('tips the tailplane up at DT, and says that the model comes down', async () => {
    const { player } = shown();
    expect(document.querySelector('.fall')).toBeNull();
    await seek(player, 18000);
    expect(turned('tailplane')).toBe('rotate(-42deg)');
    expect(document.querySelector('.fall')).toBeTruthy();
    expect(screen.getByText(en.preview.comesDown)).toBeTruthy();
  });

  it('tips it up also when a servo only releases it', async () => {
    const named = guessedUses(PROGRAM).map((use, servo) =>
      servo === 1 ? { ...use, duty: 'release' as const } : { ...use, duty: 'none' as const },
    );
    const { player } = shown({ named });
    expect(turned('tailplane')).toBe('rotate(0deg)');
    await seek(player, 18000);
    expect(turned('tailplane')).toBe('rotate(-42deg)');
    expect(stands()[1]).toBe('S2 Disc or DT line 130');
  });

  it('says so where no servo moves at DT', async () => {
    const { player } = shown({ program: programOf('Q', PROGRAM.times, [[65, 130, 0, 65, 65]]) });
    await seek(player, 18000);
    expect(screen.getByText(en.findings['dt-moves-nothing'])).toBeTruthy();
    expect([turned('tailplane'), document.querySelector('.fall')]).toEqual(['rotate(0deg)', null]);
  });

  it('lets the pilot name the servos, with the range and the direction of each', async () => {
    const said: (readonly ServoUse[] | null)[] = [];
    shown({ onName: (uses) => said.push(uses) });
    await press(en.preview.nameServos);
    const choose = (name: string, value: string) =>
      act(() => void fireEvent.change(screen.getByRole('combobox', { name }), { target: { value } }));
    const end = (name: string, value: string) =>
      act(() => void fireEvent.change(screen.getByRole('spinbutton', { name }), { target: { value } }));
    await choose('S1 moves', 'tailplane');
    await end('S1, one end in steps', '95');
    await end('S1, other end in steps', '20');
    await choose('S1, what more steps do', 'true');
    await choose('S2 moves', 'none');
    expect(
      screen.queryByRole('spinbutton', { name: 'S2, one end in steps' }),
      'a servo that moves nothing has no ends to set',
    ).toBeNull();
    await act(() => void fireEvent.submit(document.querySelector('form') as HTMLFormElement));
    expect(said).toEqual([
      [
        { duty: 'tailplane', name: '', low: 20, high: 95, reversed: true },
        { duty: 'none', name: '', low: 65, high: 130, reversed: false },
        { duty: 'wing', name: '', low: 0, high: 0, reversed: false },
      ],
    ]);
    expect(document.querySelector('dialog[open]')).toBeNull();
  });

  it('guesses again once no servo is used, and changes nothing when the naming is cancelled', async () => {
    const said: (readonly ServoUse[] | null)[] = [];
    shown({ named: guessedUses(PROGRAM), onName: (uses) => said.push(uses) });
    await press(en.preview.nameServos);
    await press(en.cancel);
    expect(said).toEqual([]);
    await press(en.preview.nameServos);
    for (const choice of screen.getAllByRole('combobox', { name: / moves$/ }))
      await act(() => void fireEvent.change(choice, { target: { value: 'none' } }));
    await act(() => void fireEvent.submit(document.querySelector('form') as HTMLFormElement));
    expect(said).toEqual([null]);
  });

  it('runs the motor until its stop, and turns the propeller only while it plays', async () => {
    const { player, run } = shown();
    const turning = () => document.querySelectorAll('.turning').length;
    expect([screen.getByText(en.preview.motor.true).tagName, turning()]).toEqual(['P', 0]);
    await press('Play');
    await run(2);
    expect(turning()).toBe(1);
    await seek(player, 1000);
    expect([screen.getByText(en.preview.motor.false).tagName, turning()]).toEqual(['P', 0]);
  });

  it.each([
    ['B', 1],
    ['E', 0],
  ])('on %s shows no motor', (timerClass, propellers) => {
    shown({ program: { ...PROGRAM, identity: { ...PROGRAM.identity, timerClass } } });
    expect(screen.queryByText(/motor/i)).toBeNull();
    expect(document.querySelectorAll('.propeller')).toHaveLength(propellers);
    expect(document.querySelectorAll('.disc, .blade'), 'no propeller turns or is folded').toHaveLength(0);
  });

  it('stops when it is removed', async () => {
    const { player, unmount } = shown();
    await press('Play');
    await act(() => void unmount());
    expect(player.playing.value).toBe(false);
  });
});
