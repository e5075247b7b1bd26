import { fetchRule } from './session/recognition.js';
import { modelLine } from './shell/header.js';
import { figures } from './shell/status-strip.js';
import { onDemand } from './ui/on-demand.js';

const allElse = () => import('./all-else.js');

/** The parts that the first picture does not need. */
export const program = onDemand(async () => (await import('./shell/program-view.js')).ProgramView);
export const memories = onDemand(async () => (await allElse()).MemoriesPage);
export const bench = onDemand(async () => (await allElse()).BenchView);
export const library = onDemand(async () => (await allElse()).LibraryPage);
export const flights = onDemand(async () => (await allElse()).FlightsView);
export const compare = onDemand(async () => (await allElse()).ComparePage);
export const line = onDemand(async () => (await allElse()).LinePanel);
export const settings = onDemand(async () => (await allElse()).SettingsView);
export const print = onDemand(async () => (await allElse()).PrintView);
export const help = onDemand(async () => (await allElse()).HelpView);
export const fileNotice = onDemand(async () => (await allElse()).LibraryFileNotice, { silent: true, later: true });
export const dialogs = onDemand(async () => (await allElse()).Dialogs, { silent: true, later: true });

/** Loads what the simulated timers need. */
export const fetchSimulated = () => import('./connect/simulated-timer.js');

/** Loads what reads and writes the files of the library. */
export const fetchFiles = allElse;

/**
 * Loads all of them: after another tab has replaced this version, they are nowhere to be found. The present view comes
 * first and alone, then the program.
 */
export async function fetchParts(): Promise<void> {
  const parts = [
    program,
    dialogs,
    figures,
    modelLine,
    memories,
    bench,
    line,
    settings,
    library,
    print,
    flights,
    fileNotice,
    help,
    compare,
  ];
  await Promise.all(parts.filter(({ isAskedFor }) => isAskedFor).map((part) => part.fetch()));
  for (const part of parts) await part.fetch();
  // Most of them are in one file. Where that came late, the first of them have failed.
  for (const part of parts) if (part.hasFailed) await part.fetch();
  // They are asked for again when they are needed, and then report what is wrong.
  await Promise.all([fetchSimulated(), fetchRule()]).catch(() => {});
}
