import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { type Signal, signal } from '@preact/signals';
import { act, render, screen } from '@testing-library/preact';
import type { ComponentChildren } from 'preact';
import { useMemo } from 'preact/hooks';
import { expect, it } from 'vitest';
// The whole page has it.
import '../../../src/app/app.js';

interface Value {
  readonly text: string;
}

const word = signal('value');

/** Stays as it is while its value is the same, as it reads a signal. */
function Part({ value }: { readonly value: Value }) {
  return (
    <p>
      {word.value}
      <Text value={value} />
    </p>
  );
}

function Text({ value }: { readonly value: Value }) {
  return <output>{value.text}</output>;
}

/** Holds for good what it was first given, as a function of its first drawing does. */
function Frame({ children }: { readonly children: ComponentChildren }) {
  const first = useMemo(() => children, []);
  return <div title={String(Boolean(first))}>{children}</div>;
}

function Whole({ values }: { readonly values: Signal<readonly Value[]> }) {
  return (
    <section>
      {values.value.map((value, at) => (
        <Part key={at} value={value} />
      ))}
      <Frame>
        <hr />
      </Frame>
    </section>
  );
}

it('keeps no drawing but the last of components that are drawn by turns', async () => {
  setFlagsFromString('--expose-gc');
  const collect: () => void = runInNewContext('gc');
  const values = signal<readonly Value[]>([{ text: 'begin' }, { text: 'begin' }]);
  render(<Whole values={values} />);
  const drawn: WeakRef<Value>[] = [];
  for (let turn = 0; turn < 20; turn++) {
    const next = { text: `turn ${turn}` };
    drawn.push(new WeakRef(next));
    act(() => {
      values.value = values.peek().map((value, at) => (at === turn % 2 ? next : value));
    });
  }
  expect(screen.getAllByRole('status').map(({ textContent }) => textContent)).toEqual(['turn 18', 'turn 19']);
  // A WeakRef holds what it refers to until the code that made it has returned.
  await new Promise((resolve) => setTimeout(resolve));
  collect();
  // The two on the screen, and the two before them.
  expect(drawn.filter((each) => each.deref()).length).toBeLessThanOrEqual(4);
});
