// What a run of mutants comes to: how many were seen, and which were not although nobody has said why that is right.

/**
 * Mutants that nobody can see, by file: the line in which they stand, what becomes of which code, and why nothing comes
 * of it.
 * @typedef {Record<string, { line: string, mutants: [code: string, becomes: string][], why: string }[]>} Equivalent
 * @typedef {{ file: string, at: string, line: string, code: string, becomes: string }} Mutant
 */

const ENDS = { Killed: 'killed', Timeout: 'timed out', Survived: 'survived', NoCoverage: 'survived', Ignored: 'prose' };

const oneLine = (text) => text.replaceAll(/\s+/g, ' ').trim();

/** What stands from one place to another. */
function between(lines, start, end) {
  const taken = lines.slice(start.line - 1, end.line);
  taken[taken.length - 1] = taken.at(-1).slice(0, end.column - 1);
  taken[0] = taken[0].slice(start.column - 1);
  return oneLine(taken.join('\n'));
}

const keyOf = ({ line, code, becomes }) => JSON.stringify([line, code, becomes]);

const placesOf = (file, list) =>
  (list[file] ?? []).flatMap(({ line, mutants }) =>
    mutants.map(([code, becomes]) => ({ file, at: '', line, code, becomes })),
  );

/**
 * @param {import('mutation-testing-report-schema').schema.MutationTestResult} report
 * @param {Equivalent} equivalent
 * @param {Equivalent} open as those, without a reason: nobody has judged them yet
 * @returns {{ counts: Record<string, number>, unseen: Mutant[], stale: Mutant[], done: Mutant[] }}
 * `unseen`: survived and not listed; `stale`: listed as equivalent and seen by a test, or no longer there; `done`: the
 * same of an open one.
 */
export function outcome(report, equivalent, open) {
  const counts = {
    mutants: 0,
    killed: 0,
    'timed out': 0,
    survived: 0,
    'of these equivalent': 0,
    'of these open': 0,
    prose: 0,
  };
  const unseen = [];
  const stale = [];
  const done = [];
  for (const [file, { source, mutants }] of Object.entries(report.files)) {
    const lines = source.split('\n');
    const listed = new Map([
      ...placesOf(file, open).map((mutant) => [keyOf(mutant), { ...mutant, list: 'open' }]),
      ...placesOf(file, equivalent).map((mutant) => [keyOf(mutant), { ...mutant, list: 'equivalent' }]),
    ]);
    const found = new Set();
    for (const { status, location, replacement } of mutants) {
      counts[ENDS[status] ?? status] = (counts[ENDS[status] ?? status] ?? 0) + 1;
      if (status !== 'Ignored') counts.mutants++;
      // Whether an endless loop is one is a matter of time on a busy machine: it may be listed, too.
      if (ENDS[status] !== 'survived' && status !== 'Timeout') continue;
      const { start, end } = location;
      const line = oneLine(lines[start.line - 1]);
      const code = between(lines, start, end);
      const becomes = oneLine(replacement ?? '');
      const mutant = { file, at: `${start.line}:${start.column}`, line, code, becomes };
      const list = listed.get(keyOf(mutant))?.list;
      found.add(keyOf(mutant));
      if (status === 'Timeout') continue;
      if (list) counts[`of these ${list}`]++;
      else unseen.push(mutant);
    }
    for (const [key, mutant] of listed) if (!found.has(key)) (mutant.list === 'open' ? done : stale).push(mutant);
  }
  return { counts, unseen, stale, done };
}

/** For whoever has to write a test, or a line of equivalent.json. */
export function unseenText({ unseen, stale, done }) {
  const text = ({ file, at, line, code, becomes }) =>
    `  ${file}:${at}  ${line}\n    ${JSON.stringify([code, becomes])}\n`;
  return [
    ...(unseen.length > 0 ? ['No test sees these:\n', ...unseen.map(text)] : []),
    ...(stale.length > 0 ? ['These stand in equivalent.json and are seen by now, or gone:\n', ...stale.map(text)] : []),
    ...(done.length > 0 ? ['Take these out of open.json, they are seen by now, or gone:\n', ...done.map(text)] : []),
  ].join('');
}

/** As open.json has them. */
export function asList(mutants) {
  const list = {};
  for (const { file, line, code, becomes } of mutants) {
    list[file] ??= [];
    const row = list[file].find((each) => each.line === line);
    if (row) row.mutants.push([code, becomes]);
    else list[file].push({ line, mutants: [[code, becomes]] });
  }
  return list;
}
