import { fetchRule } from './session/recognition.js';
import { modelLine } from './shell/header.js';
import { licenceList } from './shell/licence-part.js';
import { figures } from './shell/status-strip.js';
import { onDemand } from './ui/on-demand.js';

const allElse = () => import('./all-else.js');

/** What the first picture does not need. */
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
export const firstSteps = onDemand(async () => (await import('./help/first-steps-card.js')).FirstStepsCard, {
  silent: true,
});
export const fileNotice = onDemand(async () => (await allElse()).LibraryFileNotice, { silent: true, later: true });
export const dialogs = onDemand(async () => (await allElse()).Dialogs, { silent: true, later: true });

/** What the simulated timers are made of. */
export const fetchSimulated = () => import('./connect/simulated-timer.js');

/** What reads and writes the files of the library. */
export const fetchFiles = allElse;

/** What reads a QR code where the browser does not. */
const fetchCodeReader = () => import('qr/decode.js');

/**
 * Fetches all of them: a page whose version was replaced by another tab finds them nowhere any more. The view that is
 * on the screen comes first, and gets all of the wire; then the program.
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
    firstSteps,
    compare,
    licenceList,
  ];
  await Promise.all(parts.filter(({ isAskedFor }) => isAskedFor).map((part) => part.fetch()));
  for (const part of parts) await part.fetch();
  // It is asked for again when it is wanted, and says then what is wrong.
  await Promise.all([fetchSimulated(), fetchRule(), fetchCodeReader()]).catch(() => {});
}
