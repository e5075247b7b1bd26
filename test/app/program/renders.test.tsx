import { fireEvent } from '@testing-library/preact';
import { options, type VNode } from 'preact';
import { afterEach, expect, it } from 'vitest';
import { ChecksPanel } from '../../../src/app/program/checks-panel.js';
import { IntervalField } from '../../../src/app/program/interval-field.js';
import { LargeFigures } from '../../../src/app/program/large-figures.js';
import { DtPresets } from '../../../src/app/program/presets.js';
import { ProgramRow } from '../../../src/app/program/program-row.js';
import { ProgramTable } from '../../../src/app/program/program-table.js';
import { UndoButtons } from '../../../src/app/program/undo-buttons.js';
import { ValueField } from '../../../src/app/program/value-field.js';
import { BlockedNote, WriteButton } from '../../../src/app/program/write-button.js';
import { ProgramPage } from '../../../src/app/shell/program-page.js';
import { idle } from '../bench/bench.js';
import { connected, field } from '../screen.js';

/** The timeline is not among them: it is drawn whole, in a frame of its own. */
const COUNTED: readonly unknown[] = [
  ...[ProgramPage, ProgramTable, ProgramRow, ValueField, IntervalField, LargeFigures, DtPresets],
  ...[ChecksPanel, BlockedNote, UndoButtons, WriteButton],
];
/** Preact tells its tools by this option of each component that it draws. */
const hooks = options as { __r?: ((vnode: VNode) => void) | undefined };
const { __r: before } = hooks;

afterEach(() => {
  hooks.__r = before;
});

/** Which components are drawn for a text in a field, and how often. */
async function drawnBy(name: string, text: string): Promise<Record<string, number>> {
  const drawn: Record<string, number> = {};
  hooks.__r = (vnode) => {
    const { type } = vnode;
    if (typeof type === 'function' && COUNTED.includes(type)) drawn[type.name] = (drawn[type.name] ?? 0) + 1;
    before?.(vnode);
  };
  fireEvent.input(field(name), { target: { value: text } });
  await idle();
  hooks.__r = before;
  return drawn;
}

// A function has two intervals: to it, and from it on. DT stands in two places.
it.each([
  ['a position', 'Function 4, S2', '7', '75', { ValueField: 1 }],
  ['a time', 'Function 4 time', '12.3', '12.4', { ValueField: 1, IntervalField: 2 }],
  ['a time with nothing behind its point', 'Function 4 time', '12', '12.', { ValueField: 1 }],
  ['DT', 'DT', '4:0', '4:01', { ValueField: 2, IntervalField: 1, DtPresets: 1 }],
  ['a text that is no value', 'Function 4, S2', '7x', '7xy', { ValueField: 1 }],
  [
    'the first letter that is none',
    'Function 4, S2',
    '7',
    '7x',
    { ValueField: 1, ProgramRow: 1, ChecksPanel: 1, BlockedNote: 1, WriteButton: 1 },
  ],
  ['an interval, which moves five times', 'Function 4 interval', '1.5', '1.6', { ValueField: 6, IntervalField: 2 }],
])('a digit of %s draws what says something else, and nothing more', async (_, name, first, text, drawn) => {
  await connected();
  field(name).focus();
  fireEvent.input(field(name), { target: { value: first } });
  await idle();
  expect(await drawnBy(name, text)).toEqual(drawn);
});
