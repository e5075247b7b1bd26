import { describe, expect, it } from 'vitest';
import { describeFrame, frameName } from '../../../src/app/messages/frame-text.js';
import type { LineEntry } from '../../../src/client/index.js';
import { encodeFrame, type LayoutOptions } from '../../../src/protocol/index.js';
import { B536 } from '../../protocol/vectors.js';
import { came, damage, frameEntry, lineError, sent } from '../line/line.js';

const Q = { ...B536, timerClass: 'Q' };
const times = [1000, 1050, 1200, 1400, 1600, 1800, 2000, 2200, 2400, 2600, 18000];
const said = (entry: LineEntry, layout: LayoutOptions): string =>
  `${frameName(entry)}: ${describeFrame(entry, layout)}`;

describe('what a frame says', () => {
  it.each<[string, LineEntry, string]>([
    ['a question', sent({ name: 'GETTIMERS' }), 'Read times · GETTIMERS: '],
    [
      'the times of Q',
      came({ name: 'GETTIMERS', times }),
      'Read times, reply · GETTIMERS: DT 3:00 min, motor stop 10.0 s, functions 10.50 12.00 14.00 16.00 18.00 20.00 22.00 24.00 26.00',
    ],
    [
      'times to be written',
      sent({ name: 'SETTIMERS', times }),
      'Write times · SETTIMERS: DT 3:00 min, motor stop 10.0 s, functions 10.50 12.00 14.00 16.00 18.00 20.00 22.00 24.00 26.00',
    ],
    [
      'a position',
      sent({ name: 'SETSERVO', function: 4, servo: 1, position: 70 }),
      'Write a position · SETSERVO: Function 4, S2: 70 steps',
    ],
    [
      'a position of DT',
      sent({ name: 'SETSERVO', function: 10, servo: 0, position: 0 }),
      'Write a position · SETSERVO: DT, S1: 0 steps',
    ],
    ['an acknowledgement', came({ name: 'SETSERVO' }), 'Write a position, reply · SETSERVO: Acknowledged.'],
    [
      'positions',
      came({ name: 'GETSERVOPOS', positions: [1, 2, 3].map((n) => Array<number>(11).fill(n)) }),
      'Read positions, reply · GETSERVOPOS: S1: 1 1 1 1 1 1 1 1 1 1 1; S2: 2 2 2 2 2 2 2 2 2 2 2; S3: 3 3 3 3 3 3 3 3 3 3 3',
    ],
    [
      'what the timer is',
      came({ name: 'GETSWVER', identity: Q }),
      'Identify, reply · GETSWVER: F1Q, firmware 536, 9 functions and DT, 4 memories, 3 servos',
    ],
    ['where to move', sent({ name: 'MOVETOFUNC', function: 0 }), 'Move servos · MOVETOFUNC: Start'],
    ['a memory', came({ name: 'GETMEMORY', memory: 1 }), 'Which memory, reply · GETMEMORY: M2'],
    ['no memory', came({ name: 'GETMEMORY', memory: null }), 'Which memory, reply · GETMEMORY: It does not say which.'],
    ['a memory to select', sent({ name: 'SETMEMORY', memory: 3 }), 'Select memory · SETMEMORY: M4'],
    [
      'idle throttle',
      came({ name: 'GETLOWRPM', idleThrottle: 30 }),
      'Read idle throttle, reply · GETLOWRPM: 30, unit unknown',
    ],
    [
      'idle throttle to set',
      sent({ name: 'SETLOWRPM', idleThrottle: 5 }),
      'Write idle throttle · SETLOWRPM: 5, unit unknown',
    ],
    ['an echo', { ...sent({ name: 'GETMEMORY' }), direction: 'in' }, 'Which memory, echo · GETMEMORY: '],
    [
      'a letter of no command',
      frameEntry('in', encodeFrame(0x7a, [1])),
      'Unknown letter 7A: What it means is not known.',
    ],
    [
      'a content that does not fit',
      frameEntry('in', encodeFrame(0x62, [1, 2, 3])),
      'Read times, reply · GETTIMERS: Its content is longer or shorter than it should be.',
    ],
    ['noise', damage('noise', 'ff'), 'Damaged: noise: '],
    ['a wrong sum', damage('checksum', '00 00 00 00 00 03 6b 6c 45'), 'Damaged: wrong checksum: '],
    ['an error of the line', lineError('break'), 'Line error: break: '],
  ])('%s', (_, entry, expected) => {
    expect(said(entry, { identity: Q })).toBe(expected);
  });

  it('calls the first time reserved where it is not the motor stop', () => {
    expect(describeFrame(came({ name: 'GETTIMERS', times }), { identity: B536 })).toContain(
      'DT 3:00 min, reserved 10.00,',
    );
  });

  it('depends on what is known of the timer', () => {
    const entry = sent({ name: 'SETSERVO', function: 1, servo: 2, position: 70 });
    expect(describeFrame(entry, { identity: Q, quirks: { servoFirst: true } })).toBe('Function 2, S2: 70 steps');
  });

  it.each<[string, LineEntry]>([
    ['times', came({ name: 'GETTIMERS', times })],
    [
      'positions',
      came({ name: 'GETSERVOPOS', positions: [[1], [2], [3]].map(([n]) => Array<number>(11).fill(n as number)) }),
    ],
    ['a position', sent({ name: 'SETSERVO', function: 4, servo: 1, position: 70 })],
    ['a function', sent({ name: 'MOVETOFUNC', function: 4 })],
  ])('says when the timer has not yet said what it is: %s', (_, entry) => {
    expect(describeFrame(entry, {})).toBe('It can be read once the timer has said what it is.');
  });
});
