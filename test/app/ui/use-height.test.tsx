import { render } from '@testing-library/preact';
import { useRef } from 'preact/hooks';
import { expect, it, vi } from 'vitest';
import { useHeight } from '../../../src/app/ui/use-height.js';

function Bar({ usual }: { readonly usual?: number }) {
  const bar = useRef<HTMLDivElement>(null);
  useHeight(bar, '--bar', usual);
  return <div ref={bar} />;
}

/** What the styles are told while it is so high, one height after the other. */
function told(usual: number | undefined, ...heights: number[]): string[] {
  let tell: (height: number) => void = () => {};
  vi.stubGlobal(
    'ResizeObserver',
    class {
      constructor(callback: ResizeObserverCallback) {
        tell = (blockSize) =>
          callback([{ borderBoxSize: [{ blockSize, inlineSize: 0 }] } as unknown as ResizeObserverEntry], this);
      }
      observe(): void {}
      unobserve(): void {}
      disconnect(): void {}
    },
  );
  const { unmount } = render(usual === undefined ? <Bar /> : <Bar usual={usual} />);
  const { style } = document.documentElement;
  const said = heights.map((height) => {
    tell(height);
    return style.getPropertyValue('--bar');
  });
  unmount();
  vi.unstubAllGlobals();
  return [...said, style.getPropertyValue('--bar')];
}

it('an element tells the styles its height in whole pixels, as long as it is shown', () => {
  expect(told(undefined, 52.4, 0)).toEqual(['52px', '0px', '']);
});

it('an element does not repeat the same height, because that would style the whole page again', () => {
  const { style } = document.documentElement;
  const sets = vi.spyOn(style, 'setProperty');
  expect([told(0, 0), sets.mock.calls]).toEqual([['', ''], []]);
  sets.mockRestore();
  expect(told(0, 40, 0)).toEqual(['40px', '', '']);
});
