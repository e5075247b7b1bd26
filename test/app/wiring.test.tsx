import { useSignal } from '@preact/signals';
import { fireEvent, render, screen } from '@testing-library/preact';
import { useState } from 'preact/hooks';
import { expect, test } from 'vitest';

function Counter() {
  const [presses, setPresses] = useState(0);
  const double = useSignal(0);
  return (
    <button
      type="button"
      onClick={() => {
        setPresses(presses + 1);
        double.value += 2;
      }}
    >
      {presses} and {double}
    </button>
  );
}

for (const time of ['first', 'second']) {
  test(`hooks, signals and the cleaning up between tests work together: the ${time} time`, async () => {
    render(<Counter />);
    fireEvent.click(screen.getByRole('button', { name: '0 and 0' }));
    expect(await screen.findByRole('button', { name: '1 and 2' })).toBeTruthy();
  });
}
