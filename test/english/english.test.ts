import { describe, expect, it } from 'vitest';
import { TimerError } from '../../src/client/index.js';
import { errorText, fieldName, findingText, slotName } from '../../src/english/index.js';
import { checkProgram, fieldsOf, type TimerProgram } from '../../src/program/index.js';
import { CodecError } from '../../src/protocol/index.js';
import { ConnectionError } from '../../src/serial/index.js';

const identity = { timerClass: 'Q', firmware: '536', functions: 3, memories: 1, servos: 1 };
const program: TimerProgram = {
  identity,
  memory: 0,
  times: [5000, 10, 10, 4000],
  positions: [[1, 2, 2, 2]],
  idleThrottle: 101,
};

describe('names', () => {
  it('are those of slots and of values', () => {
    expect([0, 1, 2, 3].map((slot) => slotName(identity, slot))).toEqual(['Start', 'Function 1', 'Function 2', 'DT']);
    expect(fieldsOf(identity).map((field) => fieldName(identity, field))).toEqual([
      ...['Motor stop', 'Function 1', 'Function 2', 'DT'],
      ...['Start, S1', 'Function 1, S1', 'Function 2, S1', 'DT, S1'],
      'Idle throttle',
    ]);
    expect(fieldName({ ...identity, timerClass: 'B' }, { kind: 'time', slot: 0 })).toBe('Start');
  });
});

describe('a finding', () => {
  const said = (of: Partial<TimerProgram>) => {
    const changed = { ...program, ...of };
    return checkProgram(changed).map((finding) => findingText(finding, changed.identity));
  };

  it('is a sentence with the value, its facts and their units', () => {
    expect(said({})).toEqual([
      'Function 2 has the same time as the function above it, 0.10 s.',
      'Motor stop comes after DT (40.00 s): the model comes down with the motor running.',
      'Motor stop is later than 40.00 s, the longest motor run of F1Q.',
      'DT is shorter than 60.00 s.',
      'DT moves no servo: the timer does not bring the model down.',
      'Idle throttle is more than 100, which is unusual; the unit is not known.',
    ]);
    expect(
      said({ times: [0.5, 99999, 20, 4001], positions: [[131, 2, 2, 3]], identity: { ...identity, timerClass: 'X' } }),
    ).toEqual([
      'Start must be a whole number.',
      'Function 1 must be 0.00 s to 655.35 s.',
      'Start, S1 must be 0 to 130.',
      'DT is shorter than 60.00 s.',
      'Idle throttle is more than 100, which is unusual; the unit is not known.',
      'The class “X” is not known: its rules were not checked.',
    ]);
  });
});

describe('an error', () => {
  it('is told by its code, and any other by its message', () => {
    expect(errorText(new TimerError('busy', 'locked'))).toBe('Somebody else uses the port. Nothing was sent.');
    expect(errorText(new ConnectionError('busy', 'refused'))).toBe(
      'The port does not open. Does another program use it?',
    );
    expect(errorText(new CodecError('out-of-range', 'position', 'position must be 0 to 130, not 131'))).toContain(
      '131',
    );
    expect(errorText(new TimerError('aborted', 'by the signal').toJSON())).toBe('Stopped.');
    expect(errorText('gone')).toBe('gone');
  });
});
