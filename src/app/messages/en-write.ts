import { dotted } from './dotted.js';
import { plural } from './plural.js';

/** A write, from the difference to the verdict. */
export const write = {
  title: 'Write to the timer',
  lead: (memory: string) => `This is what changes in ${memory}. Everything else stays as it is.`,
  /** Names the choice of a memory. */
  target: 'Write to',
  nothing: 'Nothing differs. The timer is read back and compared.',
  field: 'Value',
  from: 'Timer holds',
  to: 'Will hold',
  wasRead: 'Was read',
  /** Why the difference is shown again. Nothing was sent. */
  moved: {
    model: {
      title: 'This timer seems to belong to another model now.',
      advice: 'Nothing was written. Look at the names of the models.',
    },
    edits: { title: 'The program has changed since this was shown.' },
  },
  unkept: {
    title: 'This device could not keep a backup of what the timer holds now.',
    advice: 'This memory is still as it was. Go on without a backup?',
  },
  /** The name of a table of values, made from its columns. */
  sideBySide: (names: readonly string[]) => `Values: ${names.join(', ')}`,
  withoutCopy: 'Go on without a backup',
  safety: 'The propeller is off or the model is held, and the timer is not armed.',
  acknowledge: 'I have read this and want to write it anyway.',
  stillToTick: (ticks: readonly string[]) => `Still to tick: ${ticks.join(', ')}.`,
  /** What each tick is about, in as few words as there is room for beside the button. */
  ticks: { model: 'other model', warnings: 'warnings', safety: 'propeller' },
  move: {
    why: 'This timer seems to keep positions only where its servos stand. If the servos do not move, it will probably not keep these.',
    label: 'Move the servos to each function before its positions are stored.',
    hint: 'Hold the model safely, with nothing in their way.',
    notHeld: {
      title: 'The timer acknowledged the positions but did not keep them.',
      advice:
        'This timer probably keeps them only where its servos stand. Write again, and let the servos move to each function.',
    },
    again: 'Write again…',
  },
  start: (count: number) => (count === 0 ? 'Read back and compare' : `Write ${plural(count, 'change', 'changes')}`),
  stages: {
    read: 'Reading',
    write: 'Writing',
    verify: 'Reading back',
    repair: 'Correcting',
  },
  stopping: 'Stopping after this request',
  /** A job that has selected another memory. Disconnect ends it at once. */
  stoppingBack: 'Stopping: first back to the memory from before',
  /** Also where nothing was written, only compared. */
  verified: { title: 'Verified.', advice: 'The timer was read back and holds what was shown.' },
  verdict: (memory: string, time: string, figures: readonly string[], changes: number) =>
    dotted([`${memory} verified ${time}`, ...figures, plural(changes, 'change', 'changes')]),
  asItIs: 'as it is',
  insteadOf: (value: string) => `instead of ${value}`,
  wanted: 'To be written',
  readBack: 'Read back',
  differs: {
    title: 'The timer did not take every value.',
    advice: 'The timer was read back. It holds other values here:',
  },
  unknown: {
    title: 'It is not certain what the timer holds.',
    advice:
      'The timer could not be read back completely. Read again, then write what still differs. Your changes are kept.',
  },
  /** Once a reading has shown what became of it. */
  cut: (memory: string) => `The write into ${memory} was interrupted.`,
  strayed: (memory: string) => ({
    title: `${memory} became current during the write.`,
    advice: `Some of the values may be in ${memory} now. Read it, and look at all of it before you fly it.`,
  }),
  refused: 'Nothing was written.',
  status: { differs: 'differs', unknown: 'not known' },
  putBack: 'changed by itself, put back',
};
