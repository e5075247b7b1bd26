import { act, fireEvent, render, screen } from '@testing-library/preact';
import { beforeEach, expect, it, vi } from 'vitest';
import type { Tree } from '../../../src/app/messages/catalogue.js';
import { LANGUAGES, preferredLanguage } from '../../../src/app/messages/first.js';
import { inLanguage, language, speak } from '../../../src/app/messages/language.js';
import { LanguageChoice } from '../../../src/app/ui/language-choice.js';
import { en } from '../../tools/en.js';
import { leftOut } from '../../tools/left-out.js';

/** Sentences that the tests give the page in place of a file; in German they come as the function that is set says. */
let german: () => Promise<Tree> = async () => ({ next: 'Weiter' });
const others = LANGUAGES.map((code) => [`./${code}.ftl`, async () => ({ next: 'Next' })]);
const words = inLanguage<{ next: string }>({ ...Object.fromEntries(others), './de.ftl': () => german() });

beforeEach(async () => {
  german = async () => ({ next: 'Weiter' });
  await act(() => speak('en'));
});

function Words() {
  return (
    <p>
      {words.value.next} {language.value}
    </p>
  );
}

it('a page that is open changes its language at once, and back', async () => {
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
  german = () => Promise.reject(new Error('no network'));
  await expect(speak('de')).rejects.toThrow('no network');
  expect(container.textContent, 'nothing changes halfway').toBe('Next en');
});

it('a file that does not come holds up no other language and no other part', async () => {
  let come = (_: Tree): void => {};
  german = () => new Promise((resolve) => (come = resolve));
  const { container } = render(<Words />);
  const late = speak('de');
  const part = inLanguage<{ next: string }>(
    Object.fromEntries([...others, ['./de.ftl', async () => ({ next: 'Teil' })]]),
  );
  await speak();
  expect(part.value.next, 'a part that is opened meanwhile').toBe('Next');
  await act(() => speak('fr'));
  expect(container.textContent).toBe('Next fr');
  await act(async () => {
    come({ next: 'Weiter' });
    await late;
  });
  expect(container.textContent, 'too late').toBe('Next fr');
  german = async () => ({ next: 'Weiter' });
  const again = speak('de');
  expect(part.value.next).toBe('Next');
  await act(() => again);
  expect([container.textContent, part.value.next]).toEqual(['Weiter de', 'Teil']);
});

it('a language that fails, and fails again, is not shown as chosen, and can be chosen again', async () => {
  german = () => Promise.reject(new Error('no network'));
  render(<LanguageChoice />);
  const list = screen.getByRole<HTMLSelectElement>('combobox', { name: en.label.language });
  const choose = (): Promise<void> =>
    act(() => {
      fireEvent.change(list, { target: { value: 'de' } });
    });
  for (let i = 0; i < 2; i++) {
    await choose();
    await screen.findByText(en.parts.failed);
    expect(list.value).toBe('en');
  }
  german = async () => ({ next: 'Weiter' });
  await choose();
  await vi.waitFor(() => expect(language.value).toBe('de'));
  expect(screen.queryByText(en.parts.failed)).toBeNull();
});

it.each([
  [['de_DE'], 'de'],
  [['xx', 'zh-TW', 'PT-br', 'CS'], 'cs'],
  [[], 'en'],
  [undefined, 'en'],
])('of the languages %j of a browser the page speaks %s', (languages, spoken) => {
  vi.spyOn(navigator, 'languages', 'get').mockReturnValue(languages as readonly string[]);
  expect(preferredLanguage()).toBe(spoken);
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
