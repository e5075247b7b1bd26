import { describe, expect, it } from 'vitest';
import { MockSerial } from '../../src/mock-serial/index.js';
import { availability } from '../../src/serial/index.js';

describe('availability', () => {
  it.each([
    { serial: new MockSerial(), isSecureContext: true, expected: null },
    { serial: undefined, isSecureContext: true, expected: 'unsupported' },
    { serial: undefined, isSecureContext: false, expected: 'insecure' },
    { serial: new MockSerial(), isSecureContext: true, policyAllows: true, expected: null },
    { serial: new MockSerial(), isSecureContext: true, policyAllows: false, expected: 'policy' },
    { serial: undefined, isSecureContext: true, policyAllows: false, expected: 'policy' },
    { serial: undefined, isSecureContext: false, policyAllows: false, expected: 'insecure' },
  ])(
    'is $expected when the context is secure: $isSecureContext, and the policy allows: $policyAllows',
    ({ expected, ...surroundings }) => {
      expect(availability(surroundings)).toBe(expected);
    },
  );
});
