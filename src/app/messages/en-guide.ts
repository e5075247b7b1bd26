import { whole } from './dotted.js';
import { plural } from './plural.js';

/** The help inside the page. Only its own parts need these sentences. */
export const guide = {
  pages: {
    checklist: 'Before the flight',
    trouble: 'When something is wrong',
    words: 'What the values are',
    energy: 'Energy for F1Q',
    steps: 'First steps',
  },
  /** The same where there is little room. */
  short: {
    checklist: 'Checklist',
    trouble: 'Trouble',
    words: 'Values',
    energy: 'Energy',
    steps: 'First steps',
  },
  nav: 'Help pages',
};

/** What a new pilot is told. */
export const firstSteps = {
  of: (at: number, count: number) => `First steps, ${at} of ${count}`,
  steps: {
    read: {
      title: 'Read the timer',
      text: 'Press Connect, wake the timer and hold the infrared head close. The page reads what the timer holds. Reading changes nothing and moves nothing.',
    },
    write: {
      title: 'Change and write',
      text: 'Type new values: the page marks what differs. Press Write: it first shows every difference. The page says “Verified” only when it has read the timer again and all is as you want it.',
    },
    fly: {
      title: 'Before you fly',
      text: 'The top shows which memory flies next, and its DT. Help has a checklist (on a phone: Settings, Help). The page needs no network, and nothing leaves this device.',
    },
  },
  back: 'Back',
  next: 'Next',
  done: 'Done',
  skip: 'Skip',
};

/** The values of a program, with unit and range. */
export const words = {
  title: 'What the values are',
  more: 'More about each',
  fields: {
    function: {
      name: 'Function',
      short: 'A step of the flight. At its time each servo goes to its position.',
      more: 'The functions come one after the other: start, function\u00a01, function\u00a02 and so on, then DT. A function cannot be switched off. Do you not need one? Give it the same positions as the function before: then nothing moves.',
      range: 'Usually start, nine functions and DT.',
    },
    time: {
      name: 'Time',
      short: 'When a function begins, counted from launch.',
      more: 'Type seconds, such as 12.5, or minutes and seconds, such as 2:05. For F1B and F1E the manuals do not say clearly whether the timer counts from launch or from the function before.',
      range:
        'By the manuals. F1Q: 0.1 to 99.9\u00a0s, in steps of 0.1\u00a0s. F1B: 0.01 to 9.99\u00a0s for functions 1 and 2, 0.1 to 99.9\u00a0s for the others. F1E: not known.',
    },
    after: {
      name: 'After',
      short: 'The time between the function before and this one.',
      more: 'When you type a value here, all later functions move with it. DT does not move.',
      range: 'In seconds, like the time.',
    },
    position: {
      name: 'Position',
      short: 'Where a servo stands: S1 is the first servo, S2 the second.',
      more: 'The angle of one step is not known: it depends on the servo and the linkage. Try it on the bench. Under “Name the servos” you tell the page what each one moves.',
      range: '0 to 130 steps.',
    },
    motorStop: {
      name: 'Motor stop',
      short: 'F1Q only: when the motor stops, counted from launch.',
      more: 'It is not a function: no servo moves with it. It may come at any time between start and DT.',
      range: 'By the manual 0.1 to 99.9\u00a0s, in steps of 0.1\u00a0s.',
    },
    dt: {
      name: 'DT',
      short: 'The dethermaliser: the time at which it brings the model down.',
      more: 'It is counted from launch. The page shows a DT in red when it is shorter than your own limit. A short DT is right for a test flight, and wrong for all others.',
      range:
        'By the manual 1 to 720\u00a0s, in whole seconds. More than 655\u00a0s (10:55\u00a0min) cannot be sent to any timer.',
    },
    idleThrottle: {
      name: 'Idle throttle',
      short: 'F1Q only: probably how fast the motor turns while the start switch is held.',
      more: 'The page reads and writes it as a number. What the number means is not known.',
      range: 'The page assumes 0 to 100. The unit is not known.',
    },
    memory: {
      name: 'Memory',
      short: 'A timer has several memories. Each holds one program. The one that is selected in the timer flies next.',
      more: 'M1 is the first memory. To look at another one, the page selects it, reads it and goes back. If that is interrupted, the page says which one may fly next.',
      range: 'Usually four, M1 to M4. Older timers have five.',
    },
  },
};

/** What a pilot checks before a flight. */
export const checklist = {
  lead: 'Tick each item. The ticks are for one flight and are not kept.',
  items: {
    memory: { text: 'The right memory flies next.', why: 'Each memory has its own DT.' },
    dtTime: {
      text: 'I have said the DT time aloud.',
      why: 'A short DT from a test flight ends the next flight early.',
    },
    surfaces: { text: 'Wing, tailplane and rudder sit firmly and stand as they should.', why: '' },
    battery: {
      text: 'The battery is charged, and its plug is in all the way.',
      why: 'When the timer does not run, no DT comes.',
    },
    dtSeen: {
      text: 'I have seen the servo move to DT.',
      why: 'Use the Bench view, or take the propeller off and let the timer run to its end.',
    },
    radioDt: { text: 'I have tried the radio DT, if there is one.', why: 'This page cannot send it.' },
    switch: {
      text: 'I pressed the start switch five times, and it sprang back each time.',
      why: 'While the switch sticks, the sequence does not begin, and no DT comes.',
    },
    propeller: { text: 'The propeller is fixed firmly and turns freely. Nobody is in front of it.', why: '' },
  },
  /** What is known about the connected timer. */
  known: {
    now: (memory: string, dt: string, time: string) => `${memory} flies next, ${whole(`DT ${dt}`)}, read ${time}.`,
    once: (memory: string, dt: string, time: string | null) =>
      `${memory}, ${whole(`DT ${dt}`)}, as last read${time === null ? '' : ` ${time}`}.`,
    not: (memory: string) => `It is not known what ${memory} holds. Read it before you fly.`,
    memory: 'This memory',
    simulated: 'This is a simulated timer.',
    nothing: 'No timer has been read. Connect to see its memory and DT here.',
    unwritten: (count: number) =>
      count === 1 ? '1 change is not in the timer yet.' : `${count} changes are not in the timer yet.`,
  },
  left: (count: number) => `${plural(count, 'item', 'items')} left`,
  done: 'All ticked. Good flight.',
  again: 'Clear all ticks',
  own: {
    label: 'Add your own item',
    hint: 'For example: the tracker is on. Your items stay in the list.',
    add: 'Add',
    refused: 'It is in the list already, or the list is full.',
    remove: (text: string) => `Remove “${text}”`,
    removeShort: 'Remove',
  },
};

/** Problems as a pilot sees them, and what to do. Steps for the connection stand in en-help.ts. */
export const troubles = {
  lead: 'Choose what you see.',
  symptoms: {
    noAnswer: { title: 'The timer does not answer', steps: [] as string[] },
    noAdapter: { title: 'The page does not find the adapter', steps: [] as string[] },
    refused: { title: 'The port does not open', steps: [] as string[] },
    wrongValues: {
      title: 'The values look wrong',
      steps: [
        'Look at the top: it says which memory is shown, and which one flies next. Each memory has its own values.',
        'Press “Read again”. When the line was disturbed, the page trusts a value only after two readings agree.',
        'Do the times get smaller from row to row? Then the two bytes of each time may be swapped. The page shows both orders and asks you: compare them with what you know of the timer.',
        'On F1B and F1E the times may be counted from the function before. Compare them with the handheld programmer.',
        'The page does not round what it shows or writes. A timer may round a value that is finer than its manual allows.',
      ],
    },
    cutOff: {
      title: 'The write was interrupted',
      steps: [
        'Do not fly this model yet. Nobody knows what the memory holds until it is read.',
        'Wake the timer, hold the infrared head close, press Connect. The page reads it. Then it offers to finish the write, or to go back to the old values.',
        'What the timer held before is kept: see the backups under Memories.',
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
        'Has this function the same position as the one before? Then nothing moves.',
        'Is the plug of the servo in, and the battery charged? When the battery is plugged in, the servos go to their DT position.',
        'Hold the model safely and press the row of the function in the Bench view. If the servo goes there, it and its plug are in order.',
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
      title: 'My models and settings are not here',
      steps: [
        'Is there text in the search field? Empty it. Is the model in the archive? Press Archive.',
        'Each browser keeps its own library, one for each profile and each address. Open this page in the same browser and profile, and at the same address, as when you saved them.',
        'Does the page say that its storage does not answer, or that another tab holds it? Close the other tabs of this page, and load it again.',
        'A private window deletes the library when you close it. Some browsers are set to do the same.',
        'On another device, or when the library is lost: press Import in the library, and choose the file of your last export.',
      ],
    },
  },
};

/** How much energy the rules of F1Q leave for the motor. */
export const energy = {
  lead: 'How long may the motor run? The page calculates it from the weight of the model and the power of the motor.',
  weight: 'Weight of the model',
  grams: 'g',
  power: 'Power',
  watts: 'W',
  voltage: 'Battery voltage',
  volts: 'V',
  current: 'Battery current',
  amperes: 'A',
  by: 'Power given in',
  ways: { watts: 'Watts', product: 'Volts and amperes' },
  measured: 'Measure at the battery while the motor runs at full power.',
  events: { rounds: 'Rounds', flyOff: 'Fly-off' },
  event: 'Flight',
  wrong: (least: string, most: string) => `Type a figure from ${least} to ${most}.`,
  missing: 'Type the weight and the power. The motor run is then shown here.',
  allowed: 'Allowed energy',
  joules: (joules: number) => `${joules} J`,
  run: 'Motor run',
  seconds: (seconds: string) => `${seconds} s`,
  energyBy: {
    weight: (perGram: number) => `${perGram} J for each gram`,
    ceiling: (most: number) => `the most for any model: ${most} J`,
  },
  runBy: {
    energy: 'then the energy is used up',
    time: (longest: number) => `the longest run: ${longest} s`,
  },
  onScreen: (run: string, joules: number) => `The program on the screen stops the motor at ${run}: ${joules} J.`,
  within: 'That is within the limit.',
  beyond: 'That is more than is allowed.',
  /** @param longest in seconds */
  rule: (perGram: number, most: number, longest: number) =>
    `The rule: ${perGram} J for each gram of the model, at most ${most} J, and at most ${longest} s.`,
  told: (year: number) =>
    `This is the rule as pilots told it around ${year}. Rules change: check the current Sporting Code of the FAI before a contest.`,
  flyOffTold: 'The figures for a fly-off were less certain even then.',
  limiter:
    'With an energy limiter on board, the motor stops earlier when the limit is reached. The functions after motor stop then come earlier, too. DT keeps its time.',
};
