import { computed } from '@preact/signals';
import { describeFrame, frameName, hexOf } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import { foldedText } from '../messages/search.js';
import type { LineRecord } from '../session/line-record.js';

/** What an entry of the line means, in words and in hex. */
export interface RowText {
  readonly name: string;
  readonly meaning: string;
  readonly bytes: string;
  /** Name and meaning in the form for searching. */
  readonly words: string;
}

/** An entry never changes, and each key of a search needs all of them. So each is put into words only once. */
const said = computed(() => {
  void messages.value;
  return new WeakMap<LineRecord, RowText>();
});

/** What an entry means, in the language of the page. */
export function rowText(record: LineRecord): RowText {
  const texts = said.value;
  const known = texts.get(record);
  if (known) return known;
  const [name, meaning] = [frameName(record), describeFrame(record, record.layout)];
  const text = { name, meaning, bytes: hexOf(record.bytes), words: foldedText(`${name} ${meaning}`) };
  texts.set(record, text);
  return text;
}
