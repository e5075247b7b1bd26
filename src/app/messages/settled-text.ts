import { ANSWERS, type Answers } from '../storage/records.js';
import { settle } from './en-settle.js';

export type SettledName = keyof typeof settle.names;

/** What is settled of a question, in words; null when it is open. */
export function settledText(answers: Answers, name: SettledName): string | null {
  const answer = answers[name];
  if (answer === undefined) return null;
  if (typeof answer === 'number') return name === 'delay' ? settle.delay(answer) : String(answer);
  if (answer === '6E' || answer === '6A') return answer;
  if (answer === 'unnumbered') return settle.unnumbered;
  if (name === 'moves' && answer === 'there') return settle.there;
  return name in ANSWERS && ANSWERS[name as keyof typeof ANSWERS][0] === answer ? settle.yes : settle.no;
}

/** Each question that this class of timer has, with what is settled of it. */
export function settledTexts(
  answers: Answers,
  timerClass: string,
): readonly (readonly [name: string, text: string | null])[] {
  const names = (Object.keys(settle.names) as SettledName[]).filter(
    (name) => name !== (timerClass === 'Q' ? 'reserved' : 'unlock'),
  );
  return names.map((name) => [settle.names[name], settledText(answers, name)]);
}
