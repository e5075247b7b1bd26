import { render, screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { App } from '../../../src/app/app.js';
import { NARROW } from '../../../src/app/ui/shapes.js';
import { connectedBench, idle, run } from '../bench/bench.js';
import { inWindow } from '../screen.js';

it('tried values are “in the timer” only as long as it is certain what the timer holds', async () => {
  const app = await connectedBench();
  app.session.safety.confirm();
  await run(app.bench.moveTo(4));
  await run(app.follow.start());
  inWindow((query) => query === NARROW);
  render(<App models={app.models} />);
  app.editor.type({ kind: 'position', servo: 1, slot: 4 }, '70');
  await idle();
  expect(screen.getByText('1 tried in the timer')).toBeTruthy();
  expect(document.querySelector('.changes-short')?.textContent, 'on a phone, not a change to write').toBe('1 tried');
  app.timer.core.onAnswer = ({ name }) => name === 'SETSERVO' && app.adapter.unplug();
  app.editor.type({ kind: 'position', servo: 1, slot: 4 }, '75');
  await idle();
  expect(app.session.standing.value.sure).toBe('not');
  expect(app.follow.trials.tried.value, 'a tried value is noted, and still the line is silent about it').toHaveLength(
    1,
  );
  expect(screen.queryByText(/tried in the timer/)).toBeNull();
});

it('on a phone counts what Write writes, not a time that cannot be read yet', async () => {
  const app = await connectedBench();
  inWindow((query) => query === NARROW);
  const { container } = render(<App models={app.models} />);
  const short = () => container.querySelector('.changes-short')?.textContent;
  app.editor.type({ kind: 'time', slot: 3 }, 'x');
  await idle();
  expect(short()).toBe('1');
  app.editor.type({ kind: 'position', servo: 1, slot: 4 }, '70');
  app.editor.type({ kind: 'position', servo: 1, slot: 5 }, '71');
  await idle();
  expect(short()).toBe('2');
});
