import { figures } from './shell/status-strip.js';
import { onDemand, speaking } from './ui/on-demand.js';

const programFile = onDemand(() => import('./shell/program-view.js'));
/** Everything that neither the start nor the program view needs. */
export const allElse = onDemand(() => import('./all-else.js'));

/** The parts that the first picture does not need. */
export const Program = programFile.part(({ ProgramView }) => ProgramView);
export const Memories = allElse.part(({ MemoriesPage }) => MemoriesPage);
export const Bench = allElse.part(({ BenchPanel }) => BenchPanel);
export const Library = allElse.part(({ LibraryPage }) => LibraryPage);
export const Flights = allElse.part(({ FlightsView }) => FlightsView);
/** For the program view. */
export const FlyingThis = allElse.part(({ FlyingThis: Part }) => Part, { silent: true });
export const Compare = allElse.part(({ ComparePage }) => ComparePage);
export const Line = allElse.part(({ LinePanel }) => LinePanel);
export const Settings = allElse.part(({ SettingsView }) => SettingsView);
export const Print = allElse.part(({ PrintView }) => PrintView);
export const Help = allElse.part(({ HelpView }) => HelpView);
export const Recognized = allElse.part(({ ModelLine }) => ModelLine, { silent: true });
export const FileNotice = allElse.part(({ LibraryFileNotice }) => LibraryFileNotice, { silent: true });
export const Dialogs = allElse.part(({ Dialogs: Part }) => Part, { silent: true });

/** Loads what the simulated timers need. */
export const fetchSimulated = () => import('./connect/simulated-timer.js');

/** Loads what reads and writes the files of the library. */
export const fetchFiles = () => import('./all-else.js').then(speaking);

/**
 * Loads all of them: after another tab has replaced this version, they are nowhere to be found. The present view comes
 * first.
 */
export async function fetchParts(): Promise<void> {
  for (const file of allElse.isAskedFor ? [allElse, programFile] : [programFile, allElse]) await file.fetch();
  await figures.fetch();
  // It is asked for again when it is needed, and then reports what is wrong.
  await fetchSimulated().catch(() => {});
}
