import type { JSX } from 'preact';
import { useMemo } from 'preact/hooks';

interface KeptProps {
  /** Everything that the drawing depends on. Always the same number of things. */
  readonly on: readonly unknown[];
  readonly draw: () => JSX.Element | null;
}

/** A part of a picture that is drawn again only when one of these things has changed. */
export function Kept({ on, draw }: KeptProps) {
  return useMemo(draw, on);
}
