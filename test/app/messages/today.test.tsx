import { act, render, screen } from '@testing-library/preact';
import { expect, it, onTestFinished, vi } from 'vitest';
import { dayOf } from '../../../src/app/flights/flight-list.js';
import { clockText, dateText, dayText } from '../../../src/app/messages/index.js';
import { followDay } from '../../../src/app/messages/today.js';

const AT = new Date(2026, 10, 22, 14, 32).getTime();
const Text = () => <p>{`${clockText(AT)} | ${dayText(AT)}`}</p>;

it.each(['a minute later', 'when the page is seen again'])('a time of yesterday gets its day, %s', (when) => {
  vi.useFakeTimers({ toFake: ['Date', 'setInterval', 'clearInterval'], now: AT + 60_000 });
  const end = followDay();
  render(<Text />);
  expect(screen.getByText('14:32 | 14:32')).toBeTruthy();
  vi.setSystemTime(AT + 86_400_000);
  act(() => {
    if (when === 'a minute later') vi.advanceTimersByTime(60_000);
    else document.dispatchEvent(new Event('visibilitychange'));
  });
  expect(screen.getByText(/^22 Nov 2026, 14:32 \| 22 Nov$/)).toBeTruthy();
  end();
});

it('the times follow the time zone of the device, all of them at once', () => {
  vi.useFakeTimers({ toFake: ['Date', 'setInterval', 'clearInterval'], now: AT + 60_000 });
  onTestFinished(() => void vi.unstubAllEnvs());
  vi.stubEnv('TZ', 'Europe/Berlin');
  const at = Date.UTC(2026, 10, 22, 13, 32);
  vi.setSystemTime(at);
  const end = followDay();
  const Times = () => <p>{`${clockText(at)} | ${dateText(at)} | ${dayOf({ at })}`}</p>;
  render(<Times />);
  expect(screen.getByText('14:32 | 22 Nov 2026, 14:32 | 2026-11-22')).toBeTruthy();
  vi.stubEnv('TZ', 'Europe/London');
  act(() => void vi.advanceTimersByTime(60_000));
  expect(screen.getByText('13:32 | 22 Nov 2026, 13:32 | 2026-11-22')).toBeTruthy();
  end();
});

it.each([
  ['dateText', dateText],
  ['dayOf', (at: number) => dayOf({ at })],
])('%s alone is drawn again when the time zone changes', (_, text) => {
  vi.useFakeTimers({ toFake: ['Date', 'setInterval', 'clearInterval'], now: AT });
  const end = followDay();
  const draw = vi.fn(() => <p>{text(AT)}</p>);
  const Drawn = () => draw();
  render(<Drawn />);
  vi.spyOn(Date.prototype, 'getTimezoneOffset').mockReturnValue(-777);
  act(() => void vi.advanceTimersByTime(60_000));
  expect(draw).toHaveBeenCalledTimes(2);
  end();
});
