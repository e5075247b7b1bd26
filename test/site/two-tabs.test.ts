import { expect, test } from 'vitest';
import { type AppOptions, AppPage } from './app-page.js';

const timers: Readonly<Record<string, { options?: AppOptions; reach: (app: AppPage) => Promise<void> }>> = {
  simulated: { reach: (app) => app.trySimulated('F1Q') },
  real: { options: { bench: { granted: true } }, reach: (app) => app.connect() },
};

test.each(Object.entries(timers))(
  'two tabs with a %s timer keep their edits apart, also when both are loaded again',
  async (_, timer) => {
    const first = await AppPage.open(timer.options);
    await timer.reach(first);
    const held = await first.valueOf('Function 2, S1');
    await first.type('Function 2, S1', '7');
    await first.kept();
    const second = await first.sibling();
    await second.hasNumber();
    await expect
      .poll(() => second.text('Your changes are back.').count(), { message: 'they are those of the first' })
      .toBe(0);
    await timer.reach(second);
    await expect.poll(() => second.valueOf('Function 2, S1')).toBe(held);
    await second.type('Function 2, S1', '8');
    await second.kept();
    for (const [app, text] of [
      [first, '7'],
      [second, '8'],
      [first, '7'],
    ] as const) {
      await app.reload();
      await app.says('Your changes are back.');
      await expect.poll(() => app.valueOf('Function 2, S1')).toBe(text);
    }
    await second.page.close();
    await first.reload();
    await first.says('Your changes are back.');
    await expect
      .poll(() => first.valueOf('Function 2, S1'), { message: 'not the later one of the tab that was closed' })
      .toBe('7');
    const third = await first.sibling();
    await third.says('Your changes are back.');
    await expect.poll(() => third.valueOf('Function 2, S1')).toBe('8');
  },
);
