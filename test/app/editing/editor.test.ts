import { describe, expect, it } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { Editor } from '../../../src/app/editing/editor.js';
import { shiftFrom } from '../../../src/app/editing/edits.js';
import { fieldKey, type ProgramField, type TimerProgram, valueAt, withValue } from '../../../src/program/index.js';
import { firstContent } from '../../../src/simulator/index.js';
import { B536 } from '../../protocol/vectors.js';

const Q536 = { ...B536, timerClass: 'Q' };
const held: TimerProgram = { identity: Q536, memory: 0, ...firstContent(Q536, 0), idleThrottle: 30 };
const SMALL = { ...Q536, functions: 5, servos: 1 };
const small: TimerProgram = { identity: SMALL, memory: 0, ...firstContent(SMALL, 0), idleThrottle: null };
const DT: ProgramField = { kind: 'time', slot: 10 };
const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
const S3: ProgramField = { kind: 'position', servo: 2, slot: 4 };

function editorOf(program: TimerProgram = held): Editor {
  const editor = new Editor();
  editor.rebase(program);
  return editor;
}

/** What would be written for a field. */
function goalOf(editor: Editor, field: ProgramField): number | null {
  return editor.working.value && valueAt(editor.working.value, field);
}

describe('an edit', () => {
  const name = { code: 'change', params: {} } as const;

  it('returns why it is refused, and changes nothing', () => {
    const editor = editorOf();
    const refused = shiftFrom(held, 3, 1_000_000);
    expect(editor.apply(refused)).toEqual('refused' in refused ? refused.refused : null);
    expect([editor.working.value, editor.undoStep.value]).toEqual([held, null]);
  });

  it('does not replace a text that is not a value, unless it is an edit of that field', () => {
    const editor = editorOf();
    editor.type(S1, 'seven');
    const step = editor.undoStep.value;
    const values = [
      { field: DT, value: 20000 },
      { field: S1, value: 7 },
    ];
    expect(editor.apply({ name, values })).toEqual({ code: 'unreadable', field: S1 });
    expect([editor.textOf(S1), goalOf(editor, DT), editor.undoStep.value]).toEqual(['seven', 18000, step]);
    expect(editor.apply(setValues(name, values))).toBeNull();
    expect([editor.textOf(S1), goalOf(editor, DT)]).toEqual(['7', 20000]);
  });

  it('is not possible before anything was read', () => {
    const editor = new Editor();
    expect(editor.apply(setValues(name, [{ field: DT, value: 1 }]))).toBeNull();
    expect([editor.working.value, editor.snapshot()]).toEqual([null, null]);
  });
});

describe('what is typed', () => {
  it('stays as it was typed until the field is left, and is a value at once', () => {
    const editor = editorOf();
    editor.type(DT, '280');
    expect([editor.textOf(DT), goalOf(editor, DT)]).toEqual(['280', 28000]);
    editor.leave(DT);
    expect(editor.textOf(DT)).toBe('4:40');
    expect(editor.changes.value).toEqual([{ field: DT, from: 18000, to: 28000 }]);
  });

  it.each([
    [S1, '', 'empty'],
    [S1, '4x', 'not-a-whole-number'],
    [DT, 'abc', 'not-a-time'],
    [DT, '1.234', 'too-fine'],
  ] as const)('%j: %j is kept as it is, also when the field is left, and blocks', (field, text, reason) => {
    const editor = editorOf();
    editor.type(field, text);
    editor.leave(field);
    expect(editor.textOf(field)).toBe(text);
    expect([...editor.unreadable.value]).toEqual([[fieldKey(field), { field, reason }]]);
    expect([editor.blocked.value, editor.dirty.value, editor.changes.value.length]).toEqual([true, true, 0]);
    expect(goalOf(editor, field), 'the goal keeps the last readable value').toBe(valueAt(held, field));
  });

  it.each([
    [S1, '131', 'position-out-of-range'],
    [S1, '-1', 'position-out-of-range'],
    [DT, '655.36', 'time-out-of-range'],
    [{ kind: 'idleThrottle' }, '256', 'throttle-out-of-range'],
  ] as const)('%j: %j has a value that no timer can hold, and blocks', (field, text, code) => {
    const editor = editorOf();
    editor.type(field, text);
    expect(editor.findings.value.filter(({ severity }) => severity === 'error')).toMatchObject([{ code, field }]);
    expect(editor.blocked.value).toBe(true);
    editor.revert(field);
    expect(editor.blocked.value).toBe(false);
  });
});

describe('going back', () => {
  it('puts one field back and leaves the others, or puts all back', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.type(DT, 'x');
    editor.revert(DT);
    expect(editor.textOf(DT)).toBe('3:00');
    expect(editor.changes.value).toEqual([{ field: S1, from: 35, to: 7 }]);
    editor.type(DT, 'x');
    editor.revertAll();
    expect([editor.textOf(DT), editor.dirty.value, editor.working.value]).toEqual(['3:00', false, held]);
  });

  it('drops a text when the value in the timer is not known', () => {
    const editor = editorOf({ ...held, idleThrottle: null });
    editor.type({ kind: 'idleThrottle' }, 'x');
    expect(editor.blocked.value).toBe(true);
    editor.revertAll();
    expect([editor.textOf({ kind: 'idleThrottle' }), editor.blocked.value]).toEqual(['', false]);
  });
});

describe('when the timer is read again', () => {
  it('keeps the edits, on top of what it holds now', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    const moved = editor.rebase(withValue(held, S3, 99));
    expect(moved).toBe(true);
    expect([goalOf(editor, S1), goalOf(editor, S3)]).toEqual([7, 99]);
    expect(editor.changes.value).toEqual([{ field: S1, from: 35, to: 7 }]);
  });

  it('does not say that it has changed when it holds the same, or when there is nothing to keep', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    expect(editor.rebase(held)).toBe(false);
    editor.revertAll();
    expect(editor.rebase(withValue(held, S3, 99))).toBe(false);
  });

  it('names a conflict as long as the field is edited', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.leave(S1);
    editor.type(DT, '4:00');
    editor.rebase([S1, DT, S3].reduce((now, field) => withValue(now, field, 99), held));
    const named = () => [...editor.conflicts.value.keys()];
    expect(named()).toEqual([DT, S1].map(fieldKey));
    editor.revert(S1);
    expect(named()).toEqual([fieldKey(DT)]);
    editor.undo();
    expect(named()).toEqual([DT, S1].map(fieldKey));
    editor.revertAll();
    expect(named()).toEqual([]);
  });

  it.each<[when: string, decide: (editor: Editor) => void]>([
    ['everything was put back', (editor) => editor.revertAll()],
    ['a write was read back', (editor) => editor.wrote(withValue(held, S1, 7))],
    ['another timer was read', (editor) => editor.rebase(small)],
    ['what was kept was brought back', (editor) => editor.restore({ baseline: held, working: held, texts: {} })],
  ])('names no conflict for a field that is edited after %s', (_, decide) => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.rebase(withValue(held, S1, 99));
    expect(editor.conflicts.value.size).toBe(1);
    decide(editor);
    editor.type(S1, '8');
    expect([editor.changes.value.length, editor.conflicts.value.size]).toEqual([1, 0]);
  });

  it('names with a conflict the value at the time of the edit, until the timer holds that again', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    for (const position of [99, 98]) editor.rebase(withValue(held, S1, position));
    expect([...editor.conflicts.value.values()]).toEqual([{ field: S1, from: 35, to: 98 }]);
    editor.rebase(held);
    expect(editor.conflicts.value.size).toBe(0);
  });

  it('names no conflict for a field that had changed before it was edited', () => {
    const editor = editorOf();
    editor.rebase(withValue(held, S1, 99));
    editor.type(S1, '7');
    expect(editor.conflicts.value.size).toBe(0);
  });

  it('drops an edit when the timer holds the same by now', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.leave(S1);
    editor.rebase(withValue(held, S1, 7));
    expect([editor.dirty.value, editor.textOf(S1)]).toEqual([false, '7']);
  });

  it('keeps a text that is not a value', () => {
    const editor = editorOf();
    editor.type(S1, 'seven');
    editor.rebase(withValue(held, S3, 99));
    expect([editor.textOf(S1), editor.blocked.value]).toEqual(['seven', true]);
  });

  it('keeps a value as it is being typed', () => {
    const editor = editorOf();
    editor.type(DT, '280');
    editor.rebase(withValue(held, S3, 99));
    expect([editor.textOf(DT), editor.isTyped(DT)]).toEqual(['280', true]);
  });

  it('shows the new value of the timer when the old one was typed by hand', () => {
    const editor = editorOf();
    editor.type(S1, '35');
    editor.rebase(withValue(held, S1, 99));
    expect([editor.textOf(S1), goalOf(editor, S1)]).toEqual(['99', 99]);
  });

  it('starts afresh with a timer of another layout', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.type(DT, 'x');
    editor.rebase(small);
    expect([editor.dirty.value, editor.working.value?.times.length]).toEqual([false, 6]);
  });
});

describe('a draft that is kept and brought back', () => {
  it('is the same, text for text', () => {
    const editor = editorOf();
    editor.type(S1, '7');
    editor.leave(S1);
    editor.type(DT, 'three minutes');
    const content = structuredClone(editor.snapshot());
    expect(content).not.toBeNull();
    const again = new Editor();
    if (content) again.restore(content);
    expect([again.textOf(S1), again.textOf(DT), again.blocked.value]).toEqual(['7', 'three minutes', true]);
    expect(again.changes.value).toEqual(editor.changes.value);
  });

  it('leaves out what the timer holds by now', () => {
    const editor = editorOf();
    expect(editor.fresh.value).toBe(true);
    editor.restore({ baseline: held, working: held, texts: {} });
    expect(editor.fresh.value).toBe(false);
    editor.rebase(held);
    expect(editor.fresh.value).toBe(true);
  });

  it('leaves out texts of fields that do not exist', () => {
    const editor = new Editor();
    editor.restore({ baseline: held, working: held, texts: { 'time:99': 'x', constructor: 'x' } });
    expect([editor.blocked.value, editor.snapshot()?.texts]).toEqual([false, {}]);
  });

  it('leaves out the undo steps of another layout', () => {
    const step = { name: { code: 'revert-all', params: {} }, state: { working: small, texts: {} } } as const;
    const editor = new Editor();
    editor.restore({ baseline: held, working: held, texts: {}, history: { past: [step], future: [], open: null } });
    editor.undo();
    expect([editor.undoStep.value, editor.working.value]).toEqual([null, held]);
  });
});

describe('a text that can be read in two ways', () => {
  it('is not a value, not even its beginning, and blocks until the pilot answers', () => {
    const editor = editorOf();
    for (const text of ['2', '23', '230']) editor.type(DT, text);
    expect([goalOf(editor, DT), editor.blocked.value, editor.asked.value.size]).toEqual([18000, true, 0]);
    editor.leave(DT);
    expect([...editor.asked.value]).toEqual([['time:10', [15000, 23000]]]);
    expect([editor.textOf(DT), goalOf(editor, DT), editor.blocked.value]).toEqual(['230', 18000, true]);
    editor.answer(DT, 15000);
    expect([editor.textOf(DT), goalOf(editor, DT), editor.blocked.value]).toEqual(['2:30', 15000, false]);
    editor.undo();
    expect([editor.textOf(DT), goalOf(editor, DT), editor.undoStep.value]).toEqual(['3:00', 18000, null]);
  });

  it('can be put back to what was there before', () => {
    const editor = editorOf();
    editor.type(DT, '4:00');
    editor.leave(DT);
    editor.type(DT, '2.30');
    editor.leave(DT);
    editor.takeBack(DT);
    expect([editor.textOf(DT), editor.blocked.value]).toEqual(['4:00', false]);
    editor.type(DT, '2.30');
    editor.leave(DT);
    const other: ProgramField = { kind: 'position', servo: 0, slot: 1 };
    editor.apply(setValues({ code: 'change', params: { field: fieldKey(other) } }, [{ field: other, value: 1 }]));
    editor.takeBack(DT);
    expect([editor.textOf(DT), editor.changes.value.length]).toEqual(['3:00', 1]);
  });

  it('is asked again after a reload', () => {
    const editor = editorOf();
    editor.type(DT, '3');
    const kept = editor.snapshot();
    const again = new Editor();
    expect(kept && again.restore(kept)).toBe(true);
    expect([again.asked.value.get('time:10'), again.blocked.value]).toEqual([[18000, 300], true]);
  });
});
