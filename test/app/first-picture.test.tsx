import { render } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { App } from '../../src/app/app.js';
import { appBench } from './bench/bench.js';

it('index.html contains the start as the page draws it (vitest -u writes it again)', async () => {
  const { models } = await appBench({ started: false });
  const { container } = render(<App models={models} />);
  // No white space between the elements, which the page would not have: lines end inside of them.
  const written = `${container.innerHTML.replaceAll(/(?<=<[^>]*)>/g, '\n>')}\n`;
  expect(written).not.toContain('style=');
  await expect(written).toMatchFileSnapshot('../../src/app/first-picture.html');
});
