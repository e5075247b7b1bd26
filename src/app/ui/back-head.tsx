import type { ComponentChildren, RefObject } from 'preact';
import { BackSign } from './back-sign.js';
import './back-head.css';

interface BackHeadProps {
  /** The name of the place to which it leads back. */
  readonly back: string;
  readonly onBack: () => void;
  readonly titleId: string;
  /** The heading, which can have the focus. */
  readonly heading: RefObject<HTMLHeadingElement | null>;
  readonly children: ComponentChildren;
}

/** The head of a page that replaced another, with a way back to that. */
export function BackHead({ back, onBack, titleId, heading, children }: BackHeadProps) {
  return (
    <div class="back-head">
      <button type="button" class="quiet" onClick={onBack}>
        <BackSign />
        {back}
      </button>
      <h1 id={titleId} ref={heading} tabIndex={-1}>
        {children}
      </h1>
    </div>
  );
}
