import type { LineEntry } from '../../client/index.js';
import { slotKind } from '../../program/index.js';
import {
  CodecError,
  commandOf,
  decodeReply,
  decodeRequest,
  type Frame,
  type Identity,
  type LayoutOptions,
  type Reply,
  type Request,
} from '../../protocol/index.js';
import { formatTime } from '../editing/units.js';
import { figureText, messages, slotLabel } from './index.js';
import { moreMessages } from './more.js';
import { memoryName, servoName, timerName } from './names.js';

/** The parts of a line entry that its words need. */
export type Seen = Pick<LineEntry, 'direction' | 'frame' | 'rejected' | 'error'>;

/** The name of a line entry: “Write a position · SETSERVO”, “Damaged: wrong checksum”. */
export function frameName({ direction, frame, rejected, error }: Seen): string {
  const { line } = moreMessages.value;
  if (error) return line.error[error];
  if (rejected || !frame) return line.rejected[rejected ?? 'noise'];
  const command = commandOf(frame.code);
  if (!command) return line.unknown({ letter: letterOf(frame.code) });
  const wording = command.direction === 'reply' ? line.reply : direction === 'in' ? line.echo : line.request;
  return wording({ name: line.names[command.name], letters: command.name });
}

/**
 * The meaning of a line entry: “Function 4, S2: 70 steps”. Empty where the name says everything.
 * @param layout what is known about the timer.
 */
export function describeFrame({ frame, rejected, error }: Seen, layout: LayoutOptions): string {
  const { line } = moreMessages.value;
  if (error || rejected || !frame) return '';
  try {
    return content(frame, layout);
  } catch (refused) {
    if (!(refused instanceof CodecError)) throw refused;
    return line.unreadable[refused.code];
  }
}

/** The identity of a timer: “F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos”. */
export function identityText(identity: Identity): string {
  const { firmware, functions, memories, servos } = identity;
  const { timeline } = messages.value;
  const { line } = moreMessages.value;
  return line.identity({
    name: timerName(identity),
    firmware,
    functions: timeline.functions({ count: functions - 1 }),
    memories: line.memories({ count: memories }),
    servos: timeline.servos({ count: servos }),
  });
}

/** A byte as two hex digits, as in the table of commands. */
export function letterOf(code: number): string {
  return code.toString(16).padStart(2, '0').toUpperCase();
}

function content(frame: Frame, layout: LayoutOptions): string {
  const isReply = commandOf(frame.code)?.direction === 'reply';
  return isReply ? replyText(decodeReply(frame, layout), layout) : requestText(decodeRequest(frame, layout), layout);
}

function requestText(request: Request, { identity }: LayoutOptions): string {
  const { line } = moreMessages.value;
  switch (request.name) {
    case 'SETSERVO': {
      const slot = slotLabel(known(identity), request.function);
      return line.position({ slot, servo: servoName(request.servo), steps: request.position });
    }
    case 'MOVETOFUNC':
      return slotLabel(known(identity), request.function);
    case 'SETTIMERS':
      return timesText(known(identity), request.times);
    case 'SETMEMORY':
      return memoryName(request.memory);
    case 'SETLOWRPM':
      return line.idleThrottle({ value: request.idleThrottle });
    default:
      return '';
  }
}

function replyText(reply: Reply, { identity }: LayoutOptions): string {
  const { line } = moreMessages.value;
  switch (reply.name) {
    case 'GETTIMERS':
      return timesText(known(identity), reply.times);
    case 'SETTIMERS':
      return reply.times === null ? line.acknowledged : timesText(known(identity), reply.times);
    case 'GETSERVOPOS':
      return reply.positions.map((steps, servo) => `${servoName(servo)}: ${steps.join(' ')}`).join('; ');
    case 'GETSWVER':
      return identityText(reply.identity);
    case 'GETMEMORY':
      return reply.memory === null ? line.memoryUnsaid : memoryName(reply.memory);
    case 'GETLOWRPM':
      return reply.idleThrottle === null ? line.idleThrottleUnsaid : line.idleThrottle({ value: reply.idleThrottle });
    default:
      return line.acknowledged;
  }
}

function timesText(identity: Identity, times: readonly number[]): string {
  const { edits } = messages.value;
  const { line } = moreMessages.value;
  const shown = times.map(formatTime);
  const figure = (slot: number): string => figureText(identity, { kind: 'time', slot }, times[slot] as number);
  const functions = shown.filter((_, slot) => slotKind(identity, slot) === 'function');
  return [
    edits.presets.use({ time: figure(times.length - 1) }),
    identity.timerClass === 'Q' ? line.motorStop({ time: figure(0) }) : line.reserved({ time: shown[0] as string }),
    ...(functions.length > 0 ? [line.functions({ times: functions.join(' ') })] : []),
  ].join(', ');
}

/** The identity decides which slot is DT, and what time 0 is. */
function known(identity: Identity | undefined): Identity {
  if (!identity) throw new CodecError('identity-needed', 'identity', 'the timer has not said what it is');
  return identity;
}
