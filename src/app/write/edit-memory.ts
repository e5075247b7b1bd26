import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { NotedRoundTrip, type RoundTripParts } from './noted-round-trip.js';

type EditParts = RoundTripParts & Pick<Session, 'runner' | 'connection'>;

/**
 * Reads a memory, restores the one that flies next, and opens what was read in the table. The edits of the memory
 * before are kept.
 * @param memory counted from 0.
 * @returns whether it is on the screen.
 */
export async function editMemory(session: EditParts, memory: number): Promise<boolean> {
  const { runner, reader, nextFlight, onScreen } = session;
  if (memory === nextFlight.memory.peek()) return await reader.read(true);
  const trip = new NotedRoundTrip(session, { job: 'look', memory });
  const edit = async (connection: TimerConnection, options: JobContext): Promise<void> => {
    await reader.readSent(connection, options);
    const [read] = await trip.read(connection, { ...options, memories: [memory] });
    if (read) await reader.showApart(read, options);
  };
  const end = await runner.perform('look', edit, memory);
  runner.report(end);
  await reader.readIfOpen();
  return end.good && onScreen.memory.peek() === memory;
}

/** Reads the memory on the screen again. */
export async function readShown(session: EditParts): Promise<void> {
  const { onScreen, reader } = session;
  const memory = onScreen.memory.peek();
  await (onScreen.apart.peek() && memory !== null ? editMemory(session, memory) : reader.read());
}

/**
 * Connects to a timer like the one from which the program on the screen came, and reads it. A connection shows what
 * flies next: a memory that was opened apart from that is read, too, and comes back with its changes.
 * @returns whether the program that was on the screen is there.
 */
export async function comeBack(session: EditParts & Pick<Session, 'timer'>): Promise<boolean> {
  const { timer, editor, onScreen, connection } = session;
  const shown = onScreen.apart.peek() ? editor.working.peek() : null;
  const key = shown && onScreen.keyOf(shown);
  await timer.comeBack();
  if (shown === null || shown.memory === null || onScreen.memory.peek() === shown.memory) return true;
  const there = editor.baseline.peek();
  const isLike = connection.peek() && there && onScreen.keyOf({ ...there, memory: shown.memory }) === key;
  return isLike ? await editMemory(session, shown.memory) : false;
}
