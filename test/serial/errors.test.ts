import { expect, it } from 'vitest';
import { TimerError } from '../../src/client/index.js';
import { CodecError } from '../../src/protocol/index.js';
import { ConnectionError } from '../../src/serial/index.js';

it.each([
  new CodecError('out-of-range', 'position', 'position must be 0 to 130, not 131', { value: 131, min: 0, max: 130 }),
  new TimerError('no-answer', 'the timer keeps silent', { request: 'GETTIMERS', sent: 3 }, new Error('why')),
  new ConnectionError('bad-reply', 'the answer cannot be right', undefined, Uint8Array.of(1)),
])('%s goes to another window, worker or process by toJSON(): a clone of the error itself has no code', (error) => {
  const { name, code, message } = error;
  const facts = structuredClone(error.toJSON());
  expect(facts).toMatchObject({ name, code, message });
  // Everything of its own is there but the trace and the cause.
  expect(new Set(Object.keys(facts))).toEqual(
    new Set([...Object.keys(error), 'message'].filter((key) => key !== 'cause')),
  );
  expect(JSON.parse(JSON.stringify(error))).toMatchObject({ name, code, message });
  expect(structuredClone(error)).not.toHaveProperty('code');
});
