import { ANSWERS, type Answers } from '../storage/records.js';
import { moreMessages } from './more.js';
import type { MoreSentences } from './sentences.js';

export type SettledName = keyof MoreSentences['settle']['names'];

/** What is settled of a question, in words; null when it is open. */
export function settledText(answers: Answers, name: SettledName): string | null {
  const { settle: words } = moreMessages.value;
  const answer = answers[name];
  if (answer === undefined) return null;
  if (typeof answer === 'number') return name === 'delay' ? words.delay({ ms: answer }) : String(answer);
  if (answer === '6E' || answer === '6A') return answer;
  if (answer === 'unnumbered') return words.unnumbered;
  if (name === 'moves' && answer === 'there') return words.there;
  return name in ANSWERS && ANSWERS[name as keyof typeof ANSWERS][0] === answer ? words.yes : words.no;
}

/** Each question that this class of timer has, with what is settled of it. */
export function settledTexts(
  answers: Answers,
  timerClass: string,
): readonly (readonly [name: string, text: string | null])[] {
  const { names } = moreMessages.value.settle;
  return (Object.keys(names) as SettledName[])
    .filter((name) => name !== (timerClass === 'Q' ? 'reserved' : 'unlock'))
    .map((name) => [names[name], settledText(answers, name)]);
}
