import { render, screen } from '@testing-library/preact';
import { expect, it, vi } from 'vitest';
import { disturbedFor, ProgressLine } from '../../../src/app/ui/progress-line.js';
import { realClock } from '../../../src/line/index.js';

it.each([0, 86_400_000, -86_400_000])('a job on a bad line ends as late, with the clock put on by %i ms', (ms) => {
  vi.useFakeTimers();
  const progress = { done: 1, total: 4, repeats: 2, endsBy: realClock.now() + 30_000 };
  vi.setSystemTime(Date.now() + ms);
  expect(disturbedFor(progress)).toBe(30);
});

it('asks whether the timer is awake while requests are repeated: silence is no sign of a bad line', () => {
  const progress = { done: 1, total: 4, repeats: 2, endsBy: realClock.now() + 30_000 };
  render(<ProgressLine label="Reading the timer" progress={progress} />);
  expect(screen.getByText(/This ends in/).textContent).toContain('is the timer awake');
});
