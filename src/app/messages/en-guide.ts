import { whole } from './dotted.js';
import { plural } from './plural.js';

/** The help inside the page. Only its own parts need these sentences. */
export const guide = {
  pages: {
    checklist: 'Checklist',
    trouble: 'Trouble',
    words: 'Values',
    steps: 'First steps',
  },
  nav: 'Help pages',
};

/** What a new pilot is told. */
export const firstSteps = [
  'Read: press Connect, wake the timer, hold the infrared head close. Reading changes nothing and moves nothing.',
  'Write: type new values, press Write, look at every difference. “Verified” means: the timer was read again and holds what you want.',
  'Fly: the top shows which memory flies next, and its DT. The page needs no network, and nothing leaves this device.',
];

/** The values of a program, with unit and range. */
export const words = {
  function: {
    text: 'A step of the flight: at its time each servo goes to its position. To skip one, give it the positions of the function before.',
    range: 'Usually start, nine functions and DT.',
  },
  time: {
    text: 'When a function begins, counted from launch. Type 12.5 or 2:05. For F1B and F1E it is not known from where the timer counts.',
    range:
      'By the manuals. F1Q: 0.1 to 99.9\u00a0s. F1B: 0.01 to 9.99\u00a0s for functions 1 and 2, then 0.1 to 99.9\u00a0s. F1E: not known.',
  },
  after: {
    text: 'The time since the function before. All later functions move with it, DT does not.',
  },
  position: {
    name: 'Position',
    text: 'Where a servo stands. The angle of a step depends on servo and linkage: try it on the bench.',
    range: '0 to 130 steps.',
  },
  motorStop: {
    text: 'F1Q: when the motor stops, counted from launch. No servo moves with it.',
    range: 'By the manual 0.1 to 99.9\u00a0s, in steps of 0.1\u00a0s.',
  },
  dt: {
    text: 'The dethermaliser: when it brings the model down, counted from launch. Red when shorter than your limit.',
    range: '1 to 720\u00a0s by the manual. More than 10:55\u00a0min cannot be sent.',
  },
  idleThrottle: {
    text: 'F1Q: probably how fast the motor turns while the start switch is held.',
    range: 'The page assumes 0 to 100. The unit is not known.',
  },
  memory: {
    text: 'A timer has several memories, each with one program. The selected one flies next. A look at another one selects it and goes back; if that is interrupted, the page says which one may fly next.',
    range: 'Usually four, M1 to M4. Older timers have five.',
  },
};

/** What a pilot checks before a flight. */
export const checklist = {
  lead: 'Tick each item. The ticks are for one flight and are not kept.',
  items: {
    memory: 'The right memory flies next.',
    dtTime: 'I have said the DT time aloud.',
    surfaces: 'Wing, tailplane and rudder sit firmly and stand as they should.',
    battery: 'The battery is charged, and its plug is in all the way.',
    dtSeen: 'I have seen the servo move to DT.',
    radioDt: 'I have tried the radio DT, if there is one.',
    switch: 'I pressed the start switch five times, and it sprang back each time.',
    propeller: 'The propeller is fixed firmly and turns freely. Nobody is in front of it.',
  },
  /** What is known about the connected timer. */
  known: {
    now: (memory: string, dt: string, time: string) => `${memory} flies next, ${whole(`DT ${dt}`)}, read ${time}.`,
    once: (memory: string, dt: string, time: string | null) =>
      `As last read${time === null ? '' : ` ${time}`}: ${memory}, ${whole(`DT ${dt}`)}.`,
    not: (memory: string) => `It is not known what ${memory} holds. Read it before you fly.`,
    nothing: 'No timer has been read. Connect to see its memory and DT here.',
    unwritten: (count: number) => `${plural(count, 'change', 'changes')} not in the timer yet.`,
  },
  left: (count: number) => `${plural(count, 'item', 'items')} left`,
  done: 'All ticked. Good flight.',
  again: 'Clear all ticks',
};

/** Problems as a pilot sees them, and what to do. Steps for the connection stand in en-help.ts. */
export const troubles = {
  symptoms: {
    noAnswer: { title: 'The timer does not answer', steps: [] as string[] },
    noAdapter: { title: 'The page does not find the adapter', steps: [] as string[] },
    refused: { title: 'The adapter does not open', steps: [] as string[] },
    wrongValues: {
      title: 'The values look wrong',
      steps: [
        'Look at the top: which memory is shown, and which flies next?',
        'Press “Read again”.',
        'Do the times fall from row to row? The page then asks how to read them.',
        'On F1B and F1E compare the times with the handheld programmer.',
      ],
    },
    cutOff: {
      title: 'The write was interrupted',
      steps: [
        'Do not fly this model yet. Connect: the page reads the timer, then offers to finish the write or to go back.',
        'What the timer held before is under Memories, Backups.',
      ],
    },
    noDt: {
      title: 'DT does not come, or comes at the wrong time',
      steps: [
        'Look at the top: it says which memory flies next, and its DT. Another memory has another DT.',
        'Does the start switch spring back each time? While it is held, the sequence does not begin, and no DT comes.',
        'Is the battery charged, and its plug in all the way? When the timer does not run, no DT comes.',
        'Hold the model safely and press the DT row in the Bench view. Does the servo go there, and does it release what it holds?',
        'Take the propeller off and let the timer run to its end. Do not fly before you have seen the servo move at the time of DT.',
      ],
    },
    noMove: {
      title: 'A servo does not move',
      steps: [
        'Hold the model and press its row on the bench. Nothing moves? Look at plug and battery. Moves there, but not in flight? It has the same position as the function before.',
        'Does it go to another place than the table says? A timer may store a position only for the function at which the servos stand. The page then offers to move the servos while it writes.',
        'Does it hum, or stop too early? The linkage may block it: try a smaller movement.',
      ],
    },
    noMotor: {
      title: 'The motor does not start',
      steps: [
        'After a flight the timer locks the motor. To free it, hold the model and keep your hands away from the propeller: it may start. Then hold the button “Hold to UNLOCK” in the Bench view.',
        'Has the start switch sprung back? While it is held, the motor only idles.',
        'Is the motor stop long enough? At 0.1 s the motor stops as soon as it has started.',
      ],
    },
    noLibrary: {
      title: 'My models and programs are not here',
      steps: [
        'Empty the search field, press Archive.',
        'Each browser, profile and address has its own library; a private window deletes it.',
        'On another device, or when it is lost: Import, and the file of your last export.',
      ],
    },
  },
};
