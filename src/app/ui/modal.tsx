import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { useUnsaved } from './unsaved.js';
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
export function Modal({ open, ...props }: ModalProps) {
  // Shut there is nothing of it in the page.
  return open ? <OpenModal {...props} /> : null;
}

function OpenModal({ title, head, titleId, onEscape, held, children }: Omit<ModalProps, 'open'>) {
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  useUnsaved();
  // Before the next picture: an empty dialog is never seen.
  useLayoutEffect(() => {
    const { current: opened } = dialog;
    opened?.showModal();
    // A browser gives the focus to the first button and scrolls there: it begins at its top.
    first(dialog.current, heading.current)?.focus({ preventScroll: true });
    opened?.scrollTo?.(0, 0);
    return () => {
      // Closed before it goes: a browser then gives the focus back to what had it. Nobody is told of that any more.
      dialog.current = null;
      opened?.close();
    };
  }, []);
  useLayoutEffect(() => {
    // What had the focus may have gone with the step before; a button of this one might be pressed unawares.
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
        onEscape();
      }}
      onClose={() => {
        if (!dialog.current || dialog.current.open) return;
        // A browser lets Escape be refused once, then closes anyway.
        if (held) dialog.current.showModal();
        else onEscape();
      }}
    >
      <div class="dialog-head">
        <h2 id={titleId} ref={heading} tabIndex={-1}>
          {title}
        </h2>
        {head}
      </div>
      {children}
    </dialog>
  );
}

/** What has the focus at first: a field that is there to be typed in at once, else the title. */
function first(dialog: HTMLElement | null, title: HTMLElement | null): HTMLElement | null {
  return dialog?.querySelector<HTMLElement>('[autofocus]') ?? title;
}
