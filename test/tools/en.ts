/// <reference path="../../src/app/messages/ftl.d.ts" />
import { sentencesOf } from '../../src/app/messages/catalogue.js';
import first from '../../src/app/messages/en.ftl?first';
import more from '../../src/app/messages/en.ftl?more';
import page from '../../src/app/messages/en.ftl?page';
import type { MoreSentences, PageSentences } from '../../src/app/messages/sentences.js';

/** Everything that the page says in English, for tests: a sentence is a text, or a function of its parameters. */
export const en = {
  ...first,
  ...sentencesOf<PageSentences>(page, 'en'),
  ...sentencesOf<MoreSentences>(more, 'en'),
};
