import { act, render, screen } from '@testing-library/preact';
import { afterEach, expect, it, vi } from 'vitest';
import { clockText, dayText } from '../../../src/app/messages/index.js';
import { followDay } from '../../../src/app/messages/today.js';

afterEach(() => void vi.useRealTimers());

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
