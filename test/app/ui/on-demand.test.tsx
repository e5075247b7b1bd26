import { render, screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { LANGUAGES } from '../../../src/app/messages/first.js';
import { inLanguage } from '../../../src/app/messages/language.js';
import { fetchFiles } from '../../../src/app/parts.js';
import { onDemand } from '../../../src/app/ui/on-demand.js';
import { en } from '../../tools/en.js';

const file = { Text: ({ text }: { readonly text: string }) => <p>{text}</p> };
/** A file whose first request fails. */
const brokenAtFirst = () => {
  let broken = true;
  return onDemand(async () => {
    if (!broken) return file;
    broken = false;
    throw new Error('no network');
  });
};

it('a file is fetched once when a part of it is first shown, and the part says so meanwhile', async () => {
  let fetched = 0;
  const { part, fetch } = onDemand(async () => {
    fetched++;
    return file;
  });
  const Part = part(({ Text }) => Text);
  render(<Part text="here" />);
  expect(screen.getByText(en.parts.coming)).toBeTruthy();
  expect([(await screen.findByText('here')).tagName, screen.queryByText(en.parts.coming)]).toEqual(['P', null]);
  await fetch();
  expect(fetched).toBe(1);
});

it('a file that is fetched for what it can do comes with its sentences', async () => {
  const files = LANGUAGES.map((code) => [`./${code}.ftl`, async () => ({ next: 'Next' })]);
  const words = inLanguage<{ next: string }>(Object.fromEntries(files));
  await fetchFiles();
  expect(words.value.next).toBe('Next');
});

it('a part that does not come says so, and can be fetched again', async () => {
  const Part = brokenAtFirst().part(({ Text }) => Text);
  render(<Part text="here" />);
  await screen.findByText(en.parts.failed);
  screen.getByRole('button', { name: en.parts.again }).click();
  await screen.findByText('here');
});

it('a silent part leaves nothing in its place, and is not fetched when it is drawn, but when its turn comes', async () => {
  const late = brokenAtFirst();
  const Dialogs = late.part(({ Text }) => Text, { silent: true });
  const { container } = render(<Dialogs text="here" />);
  expect([late.isAskedFor, late.hasFailed, container.innerHTML]).toEqual([false, false, '']);
  await late.fetch();
  expect([late.hasFailed, container.innerHTML]).toEqual([true, '']);
  await late.fetch();
  expect(late.hasFailed).toBe(false);
  await screen.findByText('here');
});
