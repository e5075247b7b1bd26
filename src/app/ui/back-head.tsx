import type { ComponentChildren, RefObject } from 'preact';
import './back-head.css';

interface BackHeadProps {
  /** Where the way back leads. */
  readonly back: string;
  readonly onBack: () => void;
  readonly titleId: string;
  /** The heading, which can have the focus. */
  readonly heading: RefObject<HTMLHeadingElement | null>;
  readonly children: ComponentChildren;
}

/** The head of a page that has come in place of another, with the way back to that. */
export function BackHead({ back, onBack, titleId, heading, children }: BackHeadProps) {
  return (
    <div class="back-head">
      <button type="button" class="quiet" onClick={onBack}>
        <svg class="icon" width="20" height="20" aria-hidden="true">
          <path d="M12 4L6 10L12 16" />
        </svg>
        {back}
      </button>
      <h1 id={titleId} ref={heading} tabIndex={-1}>
        {children}
      </h1>
    </div>
  );
}
