import { act, fireEvent, render, screen } from '@testing-library/preact';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { FlightPreview, type FlightPreviewProps } from '../../../../src/app/timeline/preview/flight-preview.js';
import { Player } from '../../../../src/app/timeline/preview/player.js';
import { programOf } from '../../programs.js';

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
  let callback: ((now: number) => void) | null = null;
  let now = 0;
  const player = new Player({
    next(next) {
      callback = next;
      return () => {
        callback = null;
      };
    },
  });
  const { unmount } = render(<FlightPreview program={PROGRAM} player={player} {...props} />);
  /** So many frames of 100 ms. */
  const run = (count: number) =>
    act(() => {
      for (let i = 0; i < count; i++) {
        now += 100;
        const due = callback;
        callback = null;
        due?.(now);
      }
    });
  return { player, run, unmount };
}

const press = (name: string | RegExp) => act(() => void fireEvent.click(screen.getByRole('button', { name })));
const seek = (player: Player, time: number) => act(() => player.seek(time));
const said = () => screen.getByRole('status').textContent;
const clock = () => document.querySelector('.preview-clock')?.textContent;
const turned = (surface: string) => document.querySelector<SVGElement>(`[data-surface=${surface}]`)?.style.transform;

afterEach(() => void vi.unstubAllGlobals());

describe('the flight preview', () => {
  it('says what it is', () => {
    shown();
    expect(screen.getByRole('region', { name: 'Flight preview' })).toBeTruthy();
    expect(screen.getByText('A preview of the program, not of the timer: angles are not to scale.')).toBeTruthy();
  });

  it('does not play until it is told to, then pauses and goes on', async () => {
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
    const { run } = shown();
    await press('10×');
    expect(screen.getByRole('button', { name: '10×' }).getAttribute('aria-pressed')).toBe('true');
    await press('Play');
    await run(11);
    expect(clock()).toBe('10.00 s');
  });

  it('says what has happened, once when it happens', async () => {
    const { player, run } = shown();
    const heard: (string | null)[] = [said()];
    new MutationObserver(() => heard.push(said())).observe(screen.getByRole('status'), {
      childList: true,
      characterData: true,
      subtree: true,
    });
    await press('Play');
    for (let second = 0; second < 5; second++) await run(10);
    await seek(player, 1000);
    await seek(player, 18100);
    await act(() => Promise.resolve());
    expect(heard).toEqual([
      'Launch',
      'Function 1 at 2.00 s',
      'Function 2 at 4.00 s',
      'Motor stop at 10.00 s',
      'DT at 3:00',
    ]);
  });

  it('says that it does not know, where times fall', async () => {
    const { player } = shown({ program: programOf('Q', [1000, 500, 200, 600, 18000]) });
    await seek(player, 300);
    expect(said()).toBe('Not known: the times fall');
  });

  it('goes from event to event', async () => {
    shown();
    const seen: (string | null)[] = [];
    for (const name of ['Next event', 'Next event', 'Next event', 'Next event', 'Previous event', 'Previous event']) {
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

  it('is scrubbed from launch to the end, and says where it is', async () => {
    const { player } = shown();
    const slider = screen.getByRole<HTMLInputElement>('slider', { name: 'Time of the flight' });
    await act(() => void fireEvent.input(slider, { target: { value: slider.max } }));
    expect(player.time.value).toBe(18300);
    expect(slider.getAttribute('aria-valuetext')).toBe('3:03');
    await act(() => void fireEvent.input(slider, { target: { value: '0' } }));
    expect(player.time.value).toBe(0);
  });

  it('turns each surface as its servo stands', async () => {
    const { player } = shown();
    expect([turned('rudder'), turned('tailplane'), turned('wing')]).toEqual([
      'rotate(0deg)',
      'rotate(0deg)',
      'rotate(-14deg)',
    ]);
    await seek(player, 200);
    expect(turned('rudder')).toBe('rotate(30deg)');
    expect(screen.getByText('Rudder: S1 at 130')).toBeTruthy();
    await seek(player, 18000);
    expect(turned('tailplane')).toBe('rotate(24deg)');
  });

  it('lets another servo move a surface, nothing, or the other way round', async () => {
    const kept: unknown[] = [];
    const { player } = shown({ onLinkages: (linkages) => kept.push(linkages) });
    await seek(player, 200);
    const select = screen.getByRole('combobox', { name: 'Tailplane is moved by', hidden: true });
    await act(() => void fireEvent.change(select, { target: { value: '0' } }));
    expect(turned('tailplane')).toBe('rotate(24deg)');
    await act(() => void fireEvent.click(screen.getByRole('checkbox', { name: 'Tailplane reversed', hidden: true })));
    expect(turned('tailplane')).toBe('rotate(-24deg)');
    await act(() => void fireEvent.change(select, { target: { value: '' } }));
    expect(turned('tailplane')).toBe('rotate(0deg)');
    expect(screen.getByText('Tailplane: not moved')).toBeTruthy();
    expect(kept).toHaveLength(3);
    expect(kept.at(-1)).toMatchObject({ tailplane: { servo: null, reversed: true }, rudder: { servo: 0 } });
  });

  it('takes the linkages that are kept outside', () => {
    const linkage = { servo: 2, reversed: true };
    shown({ linkages: { rudder: linkage, tailplane: { servo: null, reversed: false }, wing: linkage } });
    expect([turned('rudder'), turned('wing')]).toEqual(['rotate(30deg)', 'rotate(14deg)']);
  });

  it('runs the motor until its stop, and turns the propeller only while it plays', async () => {
    const { player, run } = shown();
    const turning = () => document.querySelectorAll('.turning').length;
    expect([screen.getByText('Motor runs').tagName, turning()]).toEqual(['LI', 0]);
    await press('Play');
    await run(2);
    expect(turning()).toBe(2);
    await seek(player, 1000);
    expect([screen.getByText('Motor stopped').tagName, turning()]).toEqual(['LI', 0]);
  });

  it.each([
    ['B', 2],
    ['E', 0],
  ])('on %s knows nothing of a motor', (timerClass, propellers) => {
    shown({ program: { ...PROGRAM, identity: { ...PROGRAM.identity, timerClass } } });
    expect(screen.queryByText(/^Motor/)).toBeNull();
    expect([document.querySelectorAll('.propeller').length, document.querySelectorAll('.disc').length]).toEqual([
      propellers,
      0,
    ]);
  });

  it('stops when it goes away', async () => {
    const { player, unmount } = shown();
    await press('Play');
    await act(() => void unmount());
    expect(player.playing.value).toBe(false);
  });

  it('ticks only when that is switched on, deeper at DT', async () => {
    const pitches: number[] = [];
    const node = class {
      connect(next: unknown): unknown {
        return next;
      }
      start(): void {}
      stop(): void {}
    };
    vi.stubGlobal(
      'AudioContext',
      class {
        currentTime = 0;
        async resume(): Promise<void> {}
        async close(): Promise<void> {}
      },
    );
    vi.stubGlobal(
      'OscillatorNode',
      class extends node {
        constructor(_: unknown, { frequency }: { frequency: number }) {
          super();
          pitches.push(frequency);
        }
      },
    );
    vi.stubGlobal(
      'GainNode',
      class extends node {
        gain = { exponentialRampToValueAtTime: () => {} };
      },
    );
    const { player, run } = shown();
    await press('Play');
    await run(30);
    expect(pitches, 'off by default').toEqual([]);
    await act(() => void fireEvent.click(screen.getByRole('checkbox', { name: 'Ticks' })));
    await run(20);
    expect(pitches).toHaveLength(1);
    await seek(player, 17990);
    pitches.length = 0;
    await run(3);
    expect(pitches).toEqual([500]);
    await act(() => void fireEvent.click(screen.getByRole('checkbox', { name: 'Ticks' })));
    await seek(player, 100);
    await run(20);
    expect(pitches).toEqual([500]);
  });
});
