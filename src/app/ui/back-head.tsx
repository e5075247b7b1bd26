import type { ComponentChildren, RefObject } from 'preact';
import { Icon } from './icon.js';
import './back-head.css';

interface BackHeadProps {
  /** The name of the place to which it leads back. */
  readonly back: string;
  /** The address of that place. */
  readonly to: `#${string}`;
  readonly titleId?: string;
  /** The heading, if it can have the focus. */
  readonly heading?: RefObject<HTMLHeadingElement | null> | null;
  /** The title, unless it stands elsewhere. */
  readonly children?: ComponentChildren;
}

/** The head of a page that replaced another, with a way back to that. */
export function BackHead({ back, to, titleId, heading = null, children }: BackHeadProps) {
  return (
    <div class="row back-head">
      <a href={to}>
        <Icon path="M8 4L2 10L8 16" width={10} />
        {back}
      </a>
      {children && (
        <h1 id={titleId} ref={heading} tabIndex={heading ? -1 : undefined}>
          {children}
        </h1>
      )}
    </div>
  );
}
