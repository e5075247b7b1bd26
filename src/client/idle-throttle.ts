import { type CommandName, encodeRequest } from '../protocol/index.js';
import { TimerError } from './errors.js';
import type { ClientJob } from './job.js';

/** The exchanges of {@link setIdleThrottle} when nothing goes wrong. */
export const SET_IDLE_THROTTLE: readonly CommandName[] = [
  'GETSWVER',
  'SETLOWRPM',
  'GETSWVER',
  'GETLOWRPM',
  'GETLOWRPM',
  'GETSWVER',
];

/** Sets the idle throttle of the identified timer, and of no other. @returns the value that two readings agree on. */
export async function setIdleThrottle({ exchange, signal }: ClientJob, idleThrottle: number): Promise<number> {
  // Refuses a value that cannot be carried before anything is sent.
  encodeRequest({ name: 'SETLOWRPM', idleThrottle });
  await exchange.requireIdentity(signal);
  await exchange.ask({ name: 'SETLOWRPM', idleThrottle }, signal);
  await exchange.requireIdentity(signal);
  const reply = await exchange.read({ name: 'GETLOWRPM' }, signal, { twice: true });
  await exchange.requireIdentity(signal);
  if (reply.idleThrottle !== null) return reply.idleThrottle;
  throw new TimerError('bad-reply', 'the reply to GETLOWRPM has no value', { request: 'GETLOWRPM' });
}
