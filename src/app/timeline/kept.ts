import type { JSX } from 'preact';
import { useMemo } from 'preact/hooks';

interface KeptProps {
  /** What the drawing is made of, always as many things. */
  readonly on: readonly unknown[];
  readonly draw: () => JSX.Element | null;
}

/** A part of a picture that is drawn again only when one of the things has changed that it is made of. */
export function Kept({ on, draw }: KeptProps) {
  return useMemo(draw, on);
}
