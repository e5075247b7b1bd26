import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef } from 'preact/hooks';
import { onBackInHistory } from '../browser/back-key.js';
import { useUnsaved } from './unsaved.js';
import './modal.css';

interface ModalProps {
  readonly open: boolean;
  readonly title: string;
  /** Stays in sight under the title, however long the rest is. */
  readonly head?: ComponentChildren;
  /**
   * Escape was pressed: closes the dialog and changes nothing, as its button to cancel does. Whoever presses Escape may
   * mean something else.
   */
  readonly onEscape: () => void;
  /** Whether only its buttons close it: while something runs, or a result has to be seen. Default: no. */
  readonly held?: boolean;
  readonly children: ComponentChildren;
}

/** A dialog that follows a model: open while the model says so, and never closed without it. */
export function Modal({ open, ...props }: ModalProps) {
  // While it is closed, nothing of it is in the page.
  return open ? <OpenModal {...props} /> : null;
}

function OpenModal({ title, head, onEscape, held = false, children }: Omit<ModalProps, 'open'>) {
  const titleId = useId();
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  const latest = useRef({ held, onEscape });
  latest.current = { held, onEscape };
  useUnsaved();
  useLayoutEffect(() => onBackInHistory(() => latest.current.held || latest.current.onEscape()), []);
  // Before the next frame, so that nobody sees an empty dialog.
  useLayoutEffect(() => {
    const { current: opened } = dialog;
    opened?.showModal();
    // A browser would focus the first button and scroll there, but the dialog should begin at its top.
    first(dialog.current, heading.current)?.focus({ preventScroll: true });
    opened?.scrollTo?.(0, 0);
    return () => {
      // Closed before it goes, so that the browser gives the focus back to where it was. Nobody is told of this close.
      dialog.current = null;
      opened?.close();
    };
  }, []);
  useLayoutEffect(() => {
    // The focused control may have gone with the last step. The focus must not fall on a button of this one, which
    // might be pressed by mistake.
    if (!dialog.current?.contains(document.activeElement)) first(dialog.current, heading.current)?.focus();
  });
  return (
    <dialog
      ref={dialog}
      class="dialog"
      tabIndex={-1}
      aria-labelledby={titleId}
      onCancel={(event) => {
        event.preventDefault();
        if (!held) onEscape();
      }}
      onClose={() => {
        if (!dialog.current || dialog.current.open) return;
        // A browser allows Escape to be refused once, then closes anyway.
        if (held) dialog.current.showModal();
        else onEscape();
      }}
    >
      <div class="stack dialog-head">
        <h2 id={titleId} ref={heading} tabIndex={-1}>
          {title.replace(/…$/, '') /* Only the button that opens it has the dots: it asks first. */}
        </h2>
        {head}
      </div>
      {children}
    </dialog>
  );
}

/** What gets the focus first: a field that is ready for typing, else the title. */
function first(dialog: HTMLElement | null, title: HTMLElement | null): HTMLElement | null {
  return dialog?.querySelector<HTMLElement>('[autofocus]') ?? title;
}
