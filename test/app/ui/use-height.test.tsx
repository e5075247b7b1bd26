import { render } from '@testing-library/preact';
import { useRef } from 'preact/hooks';
import { expect, it, vi } from 'vitest';
import { useHeight } from '../../../src/app/ui/use-height.js';

interface BarProps {
  readonly name?: '--bar' | null;
  readonly likely?: number;
}

function Bar({ name = '--bar', likely }: BarProps) {
  const bar = useRef<HTMLDivElement>(null);
  useHeight(bar, name, likely);
  return <div ref={bar} />;
}

/** What the styles are told at first, then while it is so high, one height after the other, and afterwards. */
function told(props: BarProps, ...heights: number[]): string[] {
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
  const { unmount } = render(<Bar {...props} />);
  const { style } = document.documentElement;
  const first = style.getPropertyValue('--bar');
  const said = heights.map((height) => {
    tell(height);
    return style.getPropertyValue('--bar');
  });
  unmount();
  vi.unstubAllGlobals();
  return [first, ...said, style.getPropertyValue('--bar')];
}

it('an element tells the styles its height in whole pixels, none too few, as long as it is shown', () => {
  expect(told({}, 52.4, 0)).toEqual(['', '53px', '0px', '']);
});

it('an element tells the height that it mostly has before it is drawn, then the one that it has', () => {
  expect(told({ likely: 52 }, 52, 60, 52)).toEqual(['52px', '52px', '60px', '52px', '']);
});

it('an element does not repeat the same height, because that would style the whole page again', () => {
  const { style } = document.documentElement;
  const sets = vi.spyOn(style, 'setProperty');
  told({ likely: 52 }, 52, 51.6, 60, 60);
  expect(sets.mock.calls).toEqual([
    ['--bar', '52px'],
    ['--bar', '60px'],
  ]);
  sets.mockRestore();
});

it('an element whose height no style needs tells nothing', () => {
  expect(told({ name: null }, 52)).toEqual(['', '', '']);
});
