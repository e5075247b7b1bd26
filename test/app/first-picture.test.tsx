import { act, render } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { App } from '../../src/app/app.js';
import { changeTexts } from '../../src/app/first-texts.js';
import { LANGUAGES } from '../../src/app/messages/first.js';
import { speak } from '../../src/app/messages/language.js';
import { appBench } from './bench/bench.js';

it('index.html contains the start as the page draws it, and its texts in each language (vitest -u writes them)', async () => {
  const { models } = await appBench({ started: false });
  const { container } = render(<App models={models} />);
  // No white space between the elements, which the page would not have: lines end inside of them.
  const html = container.innerHTML;
  const written = `${html.replaceAll(/(?<=<[^>]*)>/g, '\n>')}\n`;
  expect(written).not.toContain('style=');
  await expect(written).toMatchFileSnapshot('../../src/app/first-picture.html');

  const texts: Record<string, readonly string[]> = {};
  for (const language of LANGUAGES.filter((each) => each !== 'en')) {
    await act(() => speak(language));
    const said: string[] = [];
    changeTexts(container, (text) => {
      said.push(text);
      return text;
    });
    texts[language] = said;
    // Nothing but these texts is another one.
    const picture = document.createElement('div');
    picture.innerHTML = html;
    const next = said.values();
    changeTexts(picture, () => next.next().value ?? '');
    expect(picture.innerHTML).toBe(container.innerHTML);
  }
  await act(() => speak('en'));
  await expect(`${JSON.stringify(texts, null, 2)}\n`).toMatchFileSnapshot('../../src/app/first-picture.json');
});
