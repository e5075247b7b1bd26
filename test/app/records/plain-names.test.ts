import { expect, it } from 'vitest';
import { asTags } from '../../../src/app/library/tags.js';
import { beginningOf, plainName, withPlainNames } from '../../../src/app/records/plain-names.js';
import { LIMITS, requireFlight, requireModel, requireSetting } from '../../../src/program/index.js';
import { FLIGHT, MODEL, SETTING } from '../../program/library-examples.js';

const TURNS = ['\u202a', '\u202b', '\u202d', '\u202e', '\u2066', '\u2067', '\u2068', '\u2069'];
const [servo] = MODEL.servos;

it.each(TURNS)('%j in a name does not reverse a sentence', (turn) => {
  const model = {
    ...MODEL,
    name: `${turn}Lancer 07`,
    memoryNames: [`${turn}calm`],
    servos: servo ? [{ ...servo, name: turn }] : [],
  };
  expect(withPlainNames(model)).toMatchObject({ name: 'Lancer 07', memoryNames: ['calm'] });
  const setting = { ...SETTING, name: turn, tags: [turn, `a${turn}b`] };
  expect(withPlainNames(setting)).toMatchObject({ name: '–', tags: ['ab'] });
  const flight = { ...FLIGHT, modelName: turn, settingName: turn, place: `Turda${turn}`, round: `${turn}3` };
  expect(withPlainNames(flight)).toMatchObject({ modelName: '', settingName: '', place: 'Turda', round: '3' });
  expect(JSON.stringify([model, setting, flight].map(withPlainNames))).not.toContain(turn);
  requireModel(withPlainNames(model));
  requireSetting(withPlainNames(setting));
  requireFlight(withPlainNames(flight));
});

it.each([
  'Lancer 07',
  'שחף 3',
  'شاهين ٧',
  '👩‍👩‍👧 🛩️',
  'می\u200cخواهم',
  'क्\u200dष',
  '🏴\u{e0067}\u{e0062}\u{e007f}',
  'Ła̷n̴c̵e̶r',
  '<b>',
  '\uf8ff',
  '\u{1fbff}',
])('%j stays as it is', (name) => {
  expect(withPlainNames({ ...MODEL, name })).toEqual({ ...MODEL, name });
  expect(withPlainNames({ ...SETTING, name, tags: [name] })).toEqual({ ...SETTING, name, tags: [name] });
  expect(withPlainNames({ ...FLIGHT, place: name })).toEqual({ ...FLIGHT, place: name });
});

it.each<readonly [given: string, plain: string]>([
  ['Lancer\r\n07', 'Lancer 07'],
  ['calm\tmorning', 'calm morning'],
  ['\u001b[31mcalm', '[31mcalm'],
  ['fly\u2028off', 'fly off'],
  ['Turda ', 'Turda'],
  ['calm\ud83d', 'calm\ufffd'],
  ['\udfffcalm', '\ufffdcalm'],
  ['\u200b\u00ad\ufeff', ''],
  ...['\u200b', '\u200c', '\u200d', '\u200e', '\u00ad', '\u034f', '\u061c', '\u2060', '\u2064', '\ufeff', '\ufe0f'].map(
    (hidden) => [`ca${hidden}lm`, 'calm'] as const,
  ),
  ['a\ufe0f\u200d🛩\ufe0f\ufe0f', 'a🛩\ufe0f'],
  [' \u3000\u2003', ''],
  ['\u0000', ''],
])('%j becomes %j: a name stands on one line, and can be seen', (given, plain) => {
  expect(plainName(given)).toBe(plain);
  expect(plainName(plain)).toBe(plain);
  expect(withPlainNames({ ...MODEL, name: given })).toMatchObject({ name: plain || '–' });
  expect(withPlainNames({ ...SETTING, tags: [given] }).tags).toEqual(plain === '' ? [] : [plain]);
  requireModel(withPlainNames({ ...MODEL, name: given }));
});

it('a name is cut between characters, not within one', () => {
  const planes = '✈️'.repeat(30) + '🛩'.repeat(LIMITS.name);
  const cut = beginningOf(planes, LIMITS.name);
  expect([cut.isWellFormed(), [...cut].length]).toEqual([true, LIMITS.name]);
  const [tag = ''] = asTags(`a${'🛩'.repeat(LIMITS.tag)}`);
  expect([tag.isWellFormed(), [...tag].length]).toEqual([true, LIMITS.tag]);
});
