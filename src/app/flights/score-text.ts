import { moreMessages } from '../messages/more.js';
import { dayHeading, roundText } from './flight-text.js';
import { noFormula } from './flights-csv.js';
import { measureText } from './measures.js';
import type { Score, ScoreLine } from './score.js';

/** What a flight adds, in seconds, or why it adds nothing. */
export function pointsText({ flight, points }: ScoreLine): string {
  const { row, score } = moreMessages.value.flights;
  if (points !== null) return measureText(points);
  return flight.result === null ? row.noResult : score.notCounted;
}

/**
 * A score card for a message or a spreadsheet: short cells with tabs between them, which stand below each other in
 * both. Numbers stand as on the screen.
 */
export function scoreText({ rounds, others, total, models }: Score): string {
  const { csv, score: words } = moreMessages.value.flights;
  const cellsOf = (line: ScoreLine, name: string): string[] => {
    const { flight, counts, maximum } = line;
    return [name, measureText(flight.result), counts ? measureText(maximum) : '', pointsText(line)];
  };
  const after = others.filter(({ flight }) => flight.round.trim() !== '');
  const { flight } = (rounds[0] ?? others[0]) as ScoreLine;
  const heads = [csv.columns.round, csv.columns.result, csv.columns.maximum, words.counted];
  const lines = [
    ...[dayHeading(flight), flight.place, models.join(', ')].filter(Boolean).map((line) => [line]),
    [],
    // The unit would make a heading wider than the figures below it.
    heads.map((head) => head.replace(/ \(.*/, '')),
    ...rounds.map((line) => cellsOf(line, line.flight.round)),
    ...(rounds.length > 0 ? [[words.total, '', '', measureText(total)]] : []),
    ...after.map((line) => cellsOf(line, roundText(line.flight.round))),
  ];
  return lines.map((cells) => cells.map((cell) => noFormula(cell.replaceAll(/\s+/g, ' '))).join('\t')).join('\n');
}
