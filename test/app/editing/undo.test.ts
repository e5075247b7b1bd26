import fc from 'fast-check';
import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { formatValue, parseValue } from '../../../src/app/editing/content.js';
import { setValues } from '../../../src/app/editing/edit.js';
import { Editor, type EditorContent } from '../../../src/app/editing/editor.js';
import { stepValue } from '../../../src/app/editing/edits.js';
import { EMPTY_HISTORY, MAX_STEPS } from '../../../src/app/editing/history.js';
import { draftSchema } from '../../../src/app/storage/records.js';
import {
  differences,
  fieldKey,
  fieldsOf,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../../src/program/index.js';
import { programOf } from './grid-programs.js';

const held = programOf();
const DT: ProgramField = { kind: 'time', slot: 5 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const S2: ProgramField = { kind: 'position', servo: 1, slot: 3 };
const preset = { code: 'change', params: {} } as const;

function editorOf(program: TimerProgram = held): Editor {
  const editor = new Editor();
  editor.rebase(program);
  return editor;
}

function type(editor: Editor, field: ProgramField, ...texts: readonly string[]): void {
  for (const text of texts) editor.type(field, text);
  editor.leave(field);
}

function step(editor: Editor, field: ProgramField, by = 1): void {
  const { value } = editor.working;
  if (value) editor.apply(stepValue(value, field, by));
}

describe('undo and redo', () => {
  it('take back everything typed in a field as one step with a name', () => {
    const editor = editorOf();
    type(editor, DT, '4', '4:', '4:00');
    type(editor, DT, '5:00');
    expect(editor.undoStep.value).toEqual({ code: 'change', params: { field: fieldKey(DT) } });
    editor.undo();
    expect(editor.textOf(DT)).toBe('4:00');
    editor.undo();
    expect([editor.textOf(DT), editor.undoStep.value, editor.dirty.value]).toEqual(['3:00', null, false]);
    editor.redo();
    editor.redo();
    expect([editor.textOf(DT), editor.redoStep.value]).toEqual(['5:00', null]);
  });

  it.each([
    ['typed that stands there already', (editor: Editor) => type(editor, DT, '3:00', '3', '180')],
    ['typed and taken back letter by letter', (editor: Editor) => type(editor, DT, '3:005', '3:00')],
    [
      'typed that stands there already, and stepped until Escape',
      (editor: Editor) => {
        editor.type(DT, '180');
        step(editor, DT);
        editor.abandonAt(DT);
        editor.leave(DT);
      },
    ],
    [
      'stepped up and down again',
      (editor: Editor) => {
        step(editor, DT);
        step(editor, DT, -1);
        editor.leave(DT);
      },
    ],
  ])('have no step for what was %s, once the field is left', (_, act) => {
    const editor = editorOf();
    type(editor, S1, '7');
    act(editor);
    expect([editor.textOf(DT), editor.undoStep.value?.params]).toEqual(['3:00', { field: fieldKey(S1) }]);
    editor.undo();
    expect([editor.textOf(S1), editor.undoStep.value]).toEqual(['30', null]);
  });

  it('one drag is one step, however many values it went through', () => {
    const editor = editorOf();
    for (const value of [41, 42, 43]) editor.apply(setValues(preset, [{ field: S1, value }], 'drag'));
    editor.settle();
    editor.apply(setValues(preset, [{ field: S1, value: 50 }], 'drag'));
    editor.undo();
    expect(editor.textOf(S1)).toBe('43');
    editor.undo();
    expect(editor.textOf(S1)).toBe('30');
  });
});

it('undo forgets the oldest steps past its limit', () => {
  const editor = editorOf();
  for (let at = 0; at < MAX_STEPS + 5; at++) editor.apply(setValues(preset, [{ field: S1, value: at % 2 }]));
  let undone = 0;
  for (; editor.undoStep.value; undone++) editor.undo();
  expect([undone, editor.textOf(S1)]).toEqual([MAX_STEPS, '0']);
});

describe('Escape', () => {
  it('takes back what was typed since the field was entered, and then nothing', () => {
    const editor = editorOf();
    type(editor, DT, '4:00');
    editor.type(DT, '9');
    for (const isAny of [true, false]) {
      expect(editor.abandonAt(DT)).toBe(isAny);
      expect([editor.textOf(DT), editor.redoStep.value]).toEqual(['4:00', null]);
    }
  });

  it('takes back the steps, and leaves what was typed before them', () => {
    const editor = editorOf();
    editor.type(S1, '50');
    step(editor, S1);
    step(editor, S1);
    expect(editor.textOf(S1)).toBe('52');
    editor.abandonAt(S1);
    expect(editor.textOf(S1)).toBe('50');
  });
});

describe('when the timer is read again', () => {
  it('undo does not bring back old values of the timer where nobody typed', () => {
    const editor = editorOf();
    type(editor, DT, '4:00');
    editor.rebase(withValue(held, S1, 99));
    editor.undo();
    expect(editor.working.value).toEqual(withValue(held, S1, 99));
  });

  it('undo brings back what was typed, value or not, also where the timer has changed', () => {
    const editor = editorOf();
    for (const text of ['x', '7', '8']) type(editor, S1, text);
    editor.rebase(withValue(held, S1, 99));
    for (const text of ['7', 'x', '99']) {
      editor.undo();
      expect(editor.textOf(S1)).toBe(text);
    }
  });

  it('undo does not bring back a text that equals the old value of the timer', () => {
    const editor = editorOf();
    editor.type(S1, editor.textOf(S1));
    editor.type(DT, '4:00');
    editor.rebase(withValue(held, S1, 99));
    editor.undo();
    expect([editor.textOf(S1), editor.dirty.value]).toEqual(['99', false]);
  });

  it('undo keeps a value that the timer said for the first time', () => {
    const editor = editorOf({ ...held, memory: null, idleThrottle: null });
    type(editor, DT, '4:00');
    const said = { ...held, memory: 2, idleThrottle: 30 };
    editor.rebase(said);
    editor.undo();
    expect(editor.working.value).toEqual(said);
  });

  it('a write can be undone: it is an edit then', () => {
    const editor = editorOf();
    type(editor, DT, '4:00');
    editor.wrote(withValue(held, DT, 24000));
    expect(editor.dirty.value).toBe(false);
    editor.undo();
    expect(editor.changes.value).toEqual([{ field: DT, from: 24000, to: 18000 }]);
  });

  it('of another layout, nothing is left to undo', () => {
    const editor = editorOf();
    type(editor, DT, '4:00');
    editor.rebase({
      ...held,
      identity: { ...held.identity, firmware: '999', functions: 4 },
      times: held.times.slice(1),
      positions: held.positions.map((row) => row.slice(1)),
    });
    expect(editor.undoStep.value).toBeNull();
  });
});

describe('what is kept', () => {
  it('holds the steps to undo and redo, and the next edit is a new step', () => {
    const editor = editorOf();
    type(editor, S1, '7');
    type(editor, DT, '4:00');
    editor.undo();
    editor.type(S2, '8');
    editor.undo();
    editor.redo();
    editor.type(S2, '81');
    const draft = { key: 'k', ...editor.snapshot(), savedAt: 0, simulated: false };
    const again = new Editor();
    expect(again.restore(v.parse(draftSchema, structuredClone(draft)))).toBe(true);
    again.type(S2, '9');
    again.undo();
    expect(again.textOf(S2)).toBe('81');
    again.undo();
    expect(again.textOf(S2)).toBe('8');
    again.undo();
    again.undo();
    expect(again.working.value).toEqual(held);
    expect(again.undoStep.value).toBeNull();
  });

  it.each([
    ['of an earlier version, without a history', undefined],
    ['whose history cannot be read', { past: [{ name: { code: 'no such step', params: {} }, state: 1 }] }],
  ])('is taken %s', (_, history) => {
    const { history: _own, ...content } = editorOf().snapshot() ?? {};
    const draft = v.parse(draftSchema, { key: 'k', ...content, history, savedAt: 0, simulated: false });
    const editor = new Editor();
    expect([editor.restore(draft), editor.undoStep.value]).toEqual([true, null]);
  });
});

/** What a pilot can do, as the test does it to its own idea of an editor. */
const fields = fieldsOf(held.identity);
const aField = fc.constantFrom(...fields);
const aText = fc.oneof(fc.nat(200).map(String), fc.constantFrom('', 'x', '2:05.5', '12,5', '700', '1.234', '-1'));
const action = fc.oneof(
  { weight: 4, arbitrary: fc.record({ act: fc.constant('type' as const), field: aField, text: aText }) },
  { weight: 2, arbitrary: fc.record({ act: fc.constant('apply' as const), field: aField, value: fc.nat(140) }) },
  { weight: 1, arbitrary: fc.record({ act: fc.constantFrom('revert' as const), field: aField }) },
  { weight: 2, arbitrary: fc.record({ act: fc.constant('escape' as const), field: aField, text: aText }) },
  { weight: 1, arbitrary: fc.record({ act: fc.constant('read' as const), field: aField, value: fc.nat(130) }) },
  { weight: 4, arbitrary: fc.record({ act: fc.constantFrom('undo' as const, 'redo' as const) }) },
  { weight: 1, arbitrary: fc.record({ act: fc.constantFrom('revertAll' as const, 'reload' as const) }) },
);

/** Typed, stepped, and Escape: what was typed stands. The first half of it typed, and Escape: nothing was. */
function typeAndEscape(editor: Editor, field: ProgramField, text: string): void {
  const before = editor.textOf(field);
  editor.type(field, 'x');
  editor.abandonAt(field);
  expect(editor.textOf(field)).toBe(before);
  editor.type(field, text);
  const working = editor.working.value;
  step(editor, field);
  // A text that is no value has no next one, nor has the last value.
  if (editor.working.value !== working) editor.abandonAt(field);
  expect(editor.textOf(field)).toBe(text);
  editor.leave(field);
}

/** What stands in each field. */
type Screen = ReadonlyMap<string, string>;

it('screen, working copy and difference agree after any edits, undos and redos', () => {
  fc.assert(
    fc.property(fc.array(action, { minLength: 50, maxLength: 100, size: 'max' }), (actions) => {
      let editor = editorOf();
      const shown = (): Screen => new Map(fields.map((field) => [fieldKey(field), editor.textOf(field)]));
      const past: Screen[] = [];
      const future: Screen[] = [];
      for (const action of actions) {
        const before = shown();
        if (action.act === 'undo' || action.act === 'redo') {
          const [from, to] = action.act === 'undo' ? [past, future] : [future, past];
          const wanted = from.pop();
          editor[action.act]();
          expect(shown()).toEqual(wanted ?? before);
          if (wanted) to.push(before);
        } else if (action.act === 'reload') {
          const content = structuredClone(editor.snapshot());
          editor = new Editor();
          expect(content && editor.restore(content)).toBe(true);
          expect(shown()).toEqual(before);
        } else if (action.act === 'read') {
          editor.rebase(withValue(held, action.field, action.value));
          // What undo brings back follows the timer: see above.
          editor.restore({ ...(editor.snapshot() as EditorContent), history: EMPTY_HISTORY });
          past.length = future.length = 0;
        } else {
          if (action.act === 'type') type(editor, action.field, action.text);
          else if (action.act === 'escape') typeAndEscape(editor, action.field, action.text);
          else if (action.act === 'apply') editor.apply(setValues(preset, [action]));
          else if (action.act === 'revert') editor.revert(action.field);
          else editor.revertAll();
          const changed = [...shown()].some(([key, text]) => before.get(key) !== text);
          // Typing what stands there already is no step; but the first letter was one.
          if (changed) past.push(before);
          if (changed || action.act === 'type' || action.act === 'escape') future.length = 0;
          if (past.length > MAX_STEPS) past.shift();
        }
        const working = editor.working.value as TimerProgram;
        expect(editor.changes.value).toEqual(differences(editor.baseline.value as TimerProgram, working));
        for (const field of fields) {
          const text = editor.textOf(field);
          const parsed = parseValue(working.identity, field, text);
          const value = valueAt(working, field);
          // A DT of a few seconds could, if it were typed as it is shown, be meant for minutes.
          if ('either' in parsed && parsed.either[1] === value) continue;
          if ('unreadable' in parsed) expect(editor.unreadable.value.has(fieldKey(field))).toBe(true);
          else if (value !== null && value >= 0)
            expect([text, parsed.value]).toEqual([formatValue(working.identity, field, value), value]);
        }
        expect([editor.undoStep.value !== null, editor.redoStep.value !== null]).toEqual([
          past.length > 0,
          future.length > 0,
        ]);
      }
    }),
    { numRuns: 200 },
  );
});
