import { effect } from '@preact/signals';
import { locale } from '../editing/locale.js';
import type { Tree } from './catalogue.js';
import { inLanguage, language } from './language.js';
import type { PageSentences } from './sentences.js';

/** One sentence that says what happened, and one that says what to do. */
export interface Said {
  readonly title: string;
  readonly advice: string;
}

/**
 * The sentences of what is loaded first. A component that reads a signal is drawn again with its parent only if a
 * property changed, and components such as the groups of the line count on that.
 */
export const messages = inLanguage<PageSentences>(
  import.meta.glob<Tree>('./*.ftl', { query: '?page', import: 'default' }),
);

/** What is typed and pasted is in the language of the page. */
effect(() => {
  const { program, edits, slotName, times, timeline } = messages.value;
  // Not loaded yet.
  if (!program) return;
  const words = [
    [program.slot, 'function'],
    [program.time, 'time'],
    [edits.table.interval, 'after'],
    [slotName({ slot: 0, kind: 'start' }), 'start'],
    [program.motorStop, 'motor stop'],
    [program.motor, 'motor'],
    [times.units.min, 'min'],
    [times.units.s, 's'],
    [timeline.stepsUnit, 'steps'],
  ] as const;
  locale.value = {
    decimal: new Intl.NumberFormat(language.value).format(0.5).includes(',') ? ',' : '.',
    words: words.map(([own, known]) => [own.normalize('NFKC').toLowerCase(), known]),
  };
});
