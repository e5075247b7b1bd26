import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import './modal.css';

interface ModalProps {
  readonly open: boolean;
  readonly title: string;
  /** What stays in sight under the title, however long the rest is. */
  readonly head?: ComponentChildren;
  readonly titleId: string;
  /** Escape was pressed. */
  readonly onEscape: () => void;
  /** It was closed by the browser; `held` says that it has to stay. */
  readonly held: boolean;
  readonly children: ComponentChildren;
}

/** A dialog over the page that follows a model: open when the model says so, and never closed past it. */
export function Modal({ open, title, head, titleId, onEscape, held, children }: ModalProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  // Before the next picture: an empty dialog is never seen.
  useLayoutEffect(() => {
    if (open && !dialog.current?.open) {
      dialog.current?.showModal();
      // A browser gives the focus to the first button and scrolls there: it begins at its top.
      heading.current?.focus({ preventScroll: true });
      dialog.current?.scrollTo?.(0, 0);
    }
    if (!open && dialog.current?.open) dialog.current.close();
    // What had the focus may have gone with the step before; a button of this one might be pressed unawares.
    if (open && !dialog.current?.contains(document.activeElement)) heading.current?.focus();
  });
  return (
    <dialog
      ref={dialog}
      class="dialog"
      tabIndex={-1}
      aria-labelledby={titleId}
      onCancel={(event) => {
        event.preventDefault();
        onEscape();
      }}
      onClose={() => {
        // It is told late: the dialog may be open again, for something else.
        if (dialog.current?.open) return;
        // A browser lets Escape be refused once, then closes anyway.
        if (held) dialog.current?.showModal();
        else onEscape();
      }}
    >
      {open && (
        <>
          <div class="dialog-head">
            <h2 id={titleId} ref={heading} tabIndex={-1}>
              {title}
            </h2>
            {head}
          </div>
          {children}
        </>
      )}
    </dialog>
  );
}
