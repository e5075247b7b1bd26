import { expect, it } from 'vitest';
import { apart } from '../../../src/app/messages/apart.js';
import { dotted } from '../../../src/app/messages/dotted.js';
import { eitherOf } from '../../../src/app/messages/either.js';
import { messages } from '../../../src/app/messages/index.js';
import { en } from '../../tools/en.js';

const { knowledge, memoryNames } = messages.value;
const { recognition } = en.whichModel;

/** Sentences with a name and a figure after it. */
const SENTENCES: Readonly<Record<string, (name: string) => string>> = {
  facts: (name) => dotted([name, '3:00 min', null]),
  memory: (name) => `${memoryNames.named({ memory: 'M2', name })} 14:32`,
  setting: (name) => knowledge.ofSetting({ name, changes: 2 }),
  'saved setting': (name) => en.library.save.state({ name, changes: 2 }),
  model: (name) => recognition.same({ model: name, when: '14:32' }),
  models: (name) => recognition.several({ models: eitherOf([name, '07', name]) }),
  import: (name) => en.files.import.done({ what: '2', name }),
};

it.each(Object.entries(SENTENCES))(
  'a name from right to left leaves the figures of a sentence in place: %s',
  (_, say) => {
    for (const name of ['שחף', 'شاهين', 'Lancer שחף 3']) {
      const said = say(name).replaceAll('\u00a0', ' ');
      expect(said).toContain(`\u2068${name}\u2069`);
      expect(said.replaceAll(`\u2068${name}\u2069`, ''), 'every mention of the name is isolated').not.toContain(name);
    }
    expect(say('Łancer Ю 07')).not.toMatch(/[\u2068\u2069]/);
  },
);

it('a name is as it was, but for its marks', () => {
  expect([apart('Lancer 07'), apart('飛行 3'), apart('')]).toEqual(['Lancer 07', '飛行 3', '']);
});

it('a short fact does not break, and no line begins with a dot', () => {
  const place = 'Poitou, field behind the church';
  expect(dotted(['fly-off / 1', null, place])).toBe(`fly-\u2060off\u00a0/\u00a01\u00a0· ${place}`);
});
