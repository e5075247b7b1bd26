import { act, fireEvent } from '@testing-library/preact';
import { options, type VNode } from 'preact';
import { afterEach, expect, it } from 'vitest';
import { idle } from '../bench/bench.js';
import { connected, field, late } from '../screen.js';

/** Preact tells its tools by this option of each component that it draws. */
const hooks = options as { __r?: ((vnode: VNode) => void) | undefined };
const { __r: before } = hooks;

afterEach(() => {
  hooks.__r = before;
});

function type(name: string, text: string): void {
  fireEvent.input(field(name), { target: { value: text } });
}

/** Which components of the whole page are drawn at once for a text in a field, and how often. */
function drawnBy(name: string, text: string): Record<string, number> {
  const drawn: Record<string, number> = {};
  hooks.__r = (vnode) => {
    const { name } = typeof vnode.type === 'function' ? vnode.type : { name: '' };
    if (/^[A-Z]/.test(name)) drawn[name] = (drawn[name] ?? 0) + 1;
    before?.(vnode);
  };
  // The timeline, the preview and the checks come a frame later. They are not waited for.
  act(() => type(name, text));
  hooks.__r = before;
  return drawn;
}

const FIELD = { ValueCell: 1, KnownLine: 1 };
const OLD = { OldValue: 1, WasText: 1 };

it.each([
  ['a position', 'Function 4, S2', '7', '75', { ValueCell: 1 }],
  ['a time', 'Function 4 time', '12.3', '12.4', { ValueCell: 3 }],
  ['a time with nothing after its point', 'Function 4 time', '12', '12.', { ValueCell: 1 }],
  ['DT', 'DT time', '4:0', '4:01', { ValueCell: 2, DtPresets: 1, Figure: 1 }],
  [
    'a value that differs for the first time',
    'Function 4, S2',
    '55',
    '56',
    { ...FIELD, ...OLD, ReadButtons: 1, WriteButton: 1 },
  ],
  ['a text that is no value', 'Function 4, S2', '7x', '7xy', { ValueCell: 1 }],
  [
    'the first letter that makes it no value',
    'Function 4, S2',
    '7',
    '7x',
    { ...FIELD, BlockedNote: 1, ProgramExits: 1, WriteButton: 1 },
  ],
  ['an interval, which moves five times', 'Function 4 interval', '1.5', '1.6', { ValueCell: 8 }],
])('a digit typed in %s draws only what changes', async (_, name, first, text, drawn) => {
  await connected();
  field(name).focus();
  type(name, first);
  await idle();
  await late();
  expect(drawnBy(name, text)).toEqual(drawn);
});
