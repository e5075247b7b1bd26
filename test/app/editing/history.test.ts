import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  abandon,
  EMPTY_HISTORY,
  type History,
  MAX_STEPS,
  mapStates,
  recordStep,
  redo,
  type StepName,
  settle,
  type Turned,
  undo,
} from '../../../src/app/editing/history.js';

const named = (field: string): StepName => ({ code: 'change', params: { field } });

/** A program on a screen, with the history of what was done to it. */
class Screen {
  history: History<string> = EMPTY_HISTORY;
  state = 'start';

  do(state: string, group: string | null = null): this {
    this.history = recordStep(this.history, named(state), this.state, group);
    this.state = state;
    return this;
  }

  undo(): this {
    return this.#take(undo(this.history, this.state));
  }

  redo(): this {
    return this.#take(redo(this.history, this.state));
  }

  abandon(): this {
    return this.#take(abandon(this.history));
  }

  leave(): this {
    this.history = settle(this.history);
    return this;
  }

  /** The names of what can be undone, the last one first, and of what can be redone, the next one first. */
  get names(): [undo: string[], redo: string[]] {
    const { past, future } = this.history;
    const names = (steps: typeof past): string[] =>
      steps.map(({ name }) => String(Object.values(name.params))).reverse();
    return [names(past), names(future)];
  }

  #take(turned: Turned<string> | null): this {
    if (turned) ({ history: this.history, state: this.state } = turned);
    return this;
  }
}

describe('undo and redo', () => {
  it('come back to the present state, also when that changed without a step', () => {
    const screen = new Screen().do('a');
    screen.state = 'a, tidied';
    expect(screen.undo().redo().state).toBe('a, tidied');
  });

  it('do not change the history that they are given', () => {
    const history = new Screen().do('a').do('b', 'g').undo().history;
    const before = structuredClone(history);
    recordStep(history, named('x'), 'y', 'g');
    undo(history, 'x');
    redo(history, 'x');
    mapStates(history, String);
    expect(history).toEqual(before);
  });
});

describe('steps of one group', () => {
  it('are no step when they end where they began', () => {
    const screen = new Screen().do('a').do('b', 'b').do('a', 'b');
    const settled = settle(screen.history, (state) => state === screen.state);
    expect([settled.past.map(({ state }) => state), settled.open]).toEqual([['start'], null]);
    expect(settle(screen.history, (state) => state === 'b').past).toHaveLength(2);
  });
});

describe('a history', () => {
  it('forgets the oldest steps past its limit', () => {
    const screen = new Screen();
    for (let step = 0; step < MAX_STEPS + 5; step++) screen.do(String(step));
    for (let step = 0; step < MAX_STEPS + 5; step++) screen.undo();
    expect([screen.state, screen.history.future.length]).toEqual(['4', MAX_STEPS]);
  });

  it('can have its states replaced, all of them', () => {
    const screen = new Screen().do('a').do('b').undo();
    screen.history = mapStates(screen.history, (state) => state.toUpperCase());
    expect([screen.names, screen.redo().state, screen.undo().undo().state]).toEqual([[['a'], ['b']], 'B', 'START']);
  });
});

/** The same, told as simply as can be: all states one after the other, and where among them the screen is. */
interface Model {
  states: string[];
  at: number;
  open: string | null;
}

type Act = 'undo' | 'redo' | 'leave' | 'abandon' | 'reload' | { readonly state: string; readonly group: string | null };

const turns: Record<Extract<Act, string>, (model: Model, screen: Screen) => void> = {
  undo(model, screen) {
    if (model.at > 0) Object.assign(model, { at: model.at - 1, open: null });
    screen.undo();
  },
  redo(model, screen) {
    if (model.at < model.states.length - 1) Object.assign(model, { at: model.at + 1, open: null });
    screen.redo();
  },
  abandon(model, screen) {
    if (model.open !== null) {
      model.states.length = model.at;
      Object.assign(model, { at: model.at - 1, open: null });
    }
    screen.abandon();
  },
  leave(model, screen) {
    model.open = null;
    screen.leave();
  },
  reload(model, screen) {
    model.open = null;
    screen.history = settle(structuredClone(screen.history));
  },
};

function edit(model: Model, screen: Screen, state: string, group: string | null): void {
  if (group !== null && group === model.open) model.states[model.at] = state;
  else model.states = [...model.states.slice(0, model.at + 1), state].slice(-MAX_STEPS - 1);
  Object.assign(model, { at: model.states.length - 1, open: group });
  screen.do(state, group);
}

let acts = 0;

function commandOf(act: Act): fc.Command<Model, Screen> {
  return {
    check: () => true,
    run(model, screen) {
      acts++;
      if (typeof act === 'string') turns[act](model, screen);
      else edit(model, screen, act.state, act.group);
      expect(screen.state).toBe(model.states[model.at]);
      expect(screen.names).toEqual([model.states.slice(1, model.at + 1).reverse(), model.states.slice(model.at + 1)]);
    },
    toString: () => JSON.stringify(act),
  };
}

describe('whatever a pilot does', () => {
  it('undo and redo agree with a simple model, over 10,000 edits, undos and redos', () => {
    const anEdit: fc.Arbitrary<Act> = fc.record({
      state: fc.nat().map(String),
      group: fc.constantFrom(null, 'time:3', 'time:4', 'drag'),
    });
    const aTurn = fc.constantFrom<Act>('undo', 'undo', 'redo', 'leave', 'abandon', 'reload');
    const mostlyEdits = fc.oneof({ weight: 9, arbitrary: anEdit }, { weight: 1, arbitrary: aTurn });
    const commands = fc.commands(
      [anEdit, mostlyEdits, aTurn].map((act) => act.map(commandOf)),
      {
        maxCommands: 500,
        size: 'max',
      },
    );
    fc.assert(
      fc.property(commands, (run) => {
        const model: Model = { states: ['start'], at: 0, open: null };
        const screen = new Screen();
        fc.modelRun(() => ({ model, real: screen }), run);
        while (screen.history.future.length > 0) screen.redo();
        expect(screen.state).toBe(model.states.at(-1));
        for (const state of model.states.slice(0, -1).reverse()) expect(screen.undo().state).toBe(state);
        expect(screen.history.past).toEqual([]);
      }),
      { numRuns: 100 },
    );
    expect(acts).toBeGreaterThan(10_000);
  });
});
