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

/**
 * @param {import('mutation-testing-report-schema').schema.MutationTestResult} report
 * @param {Equivalent} equivalent
 * @returns {{ counts: Record<string, number>, unseen: Mutant[], stale: Mutant[] }} `unseen`: survived and not listed;
 * `stale`: listed as equivalent and seen by a test, or no longer there.
 */
export function outcome(report, equivalent) {
  const counts = {
    mutants: 0,
    killed: 0,
    'timed out': 0,
    survived: 0,
    'of these equivalent': 0,
    prose: 0,
  };
  const unseen = [];
  const stale = [];
  for (const [file, { source, mutants }] of Object.entries(report.files)) {
    const lines = source.split('\n');
    const listed = (equivalent[file] ?? []).flatMap(({ line, mutants }) =>
      mutants.map(([code, becomes]) => ({ file, at: '', line, code, becomes })),
    );
    const keys = new Set(listed.map(keyOf));
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
      found.add(keyOf(mutant));
      if (status === 'Timeout') continue;
      if (keys.has(keyOf(mutant))) counts['of these equivalent']++;
      else unseen.push(mutant);
    }
    stale.push(...listed.filter((mutant) => !found.has(keyOf(mutant))));
  }
  return { counts, unseen, stale };
}

/** For whoever has to write a test, or a line of equivalent.json. */
export function unseenText({ unseen, stale }) {
  const text = ({ file, at, line, code, becomes }) =>
    `  ${file}:${at}  ${line}\n    ${JSON.stringify([code, becomes])}\n`;
  return [
    ...(unseen.length > 0 ? ['No test sees these:\n', ...unseen.map(text)] : []),
    ...(stale.length > 0
      ? ['These stand in equivalent.json, but a test sees them now, or the code is gone:\n', ...stale.map(text)]
      : []),
  ].join('');
}
