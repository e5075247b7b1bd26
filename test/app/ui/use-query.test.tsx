import { render } from '@testing-library/preact';
import { expect, it, vi } from 'vitest';
import { useQuery } from '../../../src/app/ui/use-query.js';

it('a query is asked once, however often its component is drawn', () => {
  const asked = vi.spyOn(window, 'matchMedia');
  function Wide({ times }: { readonly times: number }) {
    return <p>{`${useQuery('(min-width: 1px)').value} ${times}`}</p>;
  }
  const { container, rerender } = render(<Wide times={1} />);
  for (const times of [2, 3]) rerender(<Wide times={times} />);
  expect([container.textContent, asked.mock.calls]).toEqual(['true 3', [['(min-width: 1px)']]]);
});
