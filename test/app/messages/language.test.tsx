import { act, render, screen } from '@testing-library/preact';
import { beforeEach, expect, it, onTestFinished } from 'vitest';
import { App } from '../../../src/app/app.js';
import type { Tree } from '../../../src/app/messages/catalogue.js';
import { LANGUAGES } from '../../../src/app/messages/first.js';
import { inLanguage, language, speak } from '../../../src/app/messages/language.js';
import { leftOut } from '../../tools/left-out.js';
import { appBench, idle } from '../bench/bench.js';
import { PLAIN } from '../flights/flights.js';
import { speakPseudo } from './pseudo.js';

beforeEach(() => localStorage.clear());

it('a page that is open changes its language at once, and back', async () => {
  const german = Promise.resolve({ next: 'Weiter' });
  let loads: Promise<Tree> = german;
  // Of the other languages, too: these sentences stay for the tests that follow.
  const others = LANGUAGES.map((code) => [`./${code}.ftl`, async () => ({ next: 'Next' })]);
  const words = inLanguage<{ next: string }>({ ...Object.fromEntries(others), './de.ftl': () => loads });
  onTestFinished(async () => {
    loads = german;
    await act(() => speak('en'));
  });
  await speak();
  const Words = () => (
    <p>
      {words.value.next} {language.value}
    </p>
  );
  const { container } = render(<Words />);
  expect(container.textContent).toBe('Next en');
  await act(() => speak('de'));
  expect(container.textContent).toBe('Weiter de');
  await act(async () => {
    await Promise.all([speak('en'), speak('de'), speak()]);
  });
  expect(container.textContent, 'the last one that was asked for').toBe('Weiter de');
  await expect(speak('xx')).rejects.toThrow('no language xx');
  await act(() => speak('en'));
  loads = Promise.reject(new Error('no network'));
  await expect(speak('de')).rejects.toThrow('no network');
  expect(container.textContent, 'nothing changes halfway').toBe('Next en');
});

/** What never comes from en.ftl. */
const KNOWN = ['Sun,\\s22\\sNov\\s2026'];

it('the bench and the flights have no text of their own that is not in en.ftl', async () => {
  const app = await appBench();
  render(<App models={app.models} />);
  screen.getByRole('button', { name: 'Connect' }).click();
  await idle();
  await app.session.library.keepFlight({ ...PLAIN, place: '1', modelName: '2' });
  speakPseudo();
  const found = new Set<string>();
  for (const show of [() => app.models.views.show('bench'), () => app.models.views.show('library', 'flights')]) {
    act(show);
    await idle();
    expect(document.body.textContent).toContain('⟦');
    for (const text of leftOut(document.body, KNOWN)) found.add(text);
  }
  expect([...found]).toEqual([]);
});

it('what is left out is found, also beside and around a sentence', () => {
  const { container } = render(
    <div title="Left out">
      <p>{'⟦Óowñ⟧'}</p>
      <p>{'⟦Óowñ ⟦íiñ⟧ ít⟧ 3:00'}</p>
      <p>{'⟦Óowñ⟧ and'}</p>
      <p>{'⟦Óowñ and⟧'}</p>
      <p>{'⟦Óowñ⟧ ⟦íiñ⟧'}</p>
      <p>{'⟦Óowñ.⟧ ⟦Íiñ⟧ ⟦3 ⟦s⟧⟧ · ⟦S1⟧ ⟦Úup⟧ Lancer 07'}</p>
      <button type="button" aria-label="Bare" />
    </div>,
  );
  expect(leftOut(container, ['Lancer \\d+'])).toEqual(['Left out', '⟦Óowñ⟧ and', '⟦Óowñ and⟧', '⟦Óowñ⟧ ⟦íiñ⟧', 'Bare']);
});
