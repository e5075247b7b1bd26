import { readFileSync } from 'node:fs';
import type { Signal } from '@preact/signals';
import { act } from '@testing-library/preact';
import { onTestFinished } from 'vitest';
import { sentencesOf } from '../../../src/app/messages/catalogue.js';
import { messages } from '../../../src/app/messages/index.js';
import { moreMessages } from '../../../src/app/messages/more.js';
import type { MoreSentences, PageSentences } from '../../../src/app/messages/sentences.js';
import { catalogueOf, ofStep, pseudo, treeOf } from '../../tools/catalogue.js';

const source = catalogueOf(readFileSync('src/app/messages/en.ftl', 'utf8'), 'en.ftl');
const tree = treeOf(source, pseudo(source));

/** Until the end of the test the page speaks the language of tests: each sentence of en.ftl stands in ⟦brackets⟧. */
export function speakPseudo(): void {
  const [page, more] = [messages as Signal<PageSentences>, moreMessages as Signal<MoreSentences>];
  const before = [page.value, more.value] as const;
  act(() => {
    page.value = sentencesOf<PageSentences>(ofStep(tree, 'page'), 'en');
    more.value = sentencesOf<MoreSentences>(ofStep(tree, 'more'), 'en');
  });
  onTestFinished(() => {
    [page.value, more.value] = before;
  });
}
