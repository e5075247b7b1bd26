import { signal } from '@preact/signals';
import type { ComponentType, FunctionComponent } from 'preact';
import { useLayoutEffect } from 'preact/hooks';
import { messages } from '../messages/index.js';

/** A part of the page that is loaded after the first picture. */
export interface OnDemand<Props> {
  /** Draws it, or says that it is coming. */
  readonly Part: FunctionComponent<Props>;
  /** Whether it was asked for: it is being loaded, or is here. */
  readonly isAskedFor: boolean;
  /** Whether it could not be loaded when it was last tried. For a silent part, which says nothing about that. */
  readonly hasFailed: boolean;
  /** Loads it. Asked again, it loads nothing twice. */
  fetch(): Promise<void>;
}

/**
 * A part of the page that is not needed for the first picture.
 * @param load imports it.
 * @param options `silent`: nothing is shown while it is missing, as for a closed dialog. `later`: drawing does not load
 * it, because visible parts come first.
 */
export function onDemand<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  { silent = false, later = false }: { readonly silent?: boolean; readonly later?: boolean } = {},
): OnDemand<Props> {
  const loaded = signal<{ readonly Component: ComponentType<Props> } | null>(null);
  const failed = signal(false);
  let coming: Promise<void> | null = null;
  const fetch = (): Promise<void> => {
    coming ??= load().then(
      (Component) => {
        loaded.value = { Component };
        failed.value = false;
      },
      () => {
        failed.value = true;
        // The next request tries again.
        coming = null;
      },
    );
    return coming;
  };
  const Part: FunctionComponent<Props> = (props) => {
    const here = loaded.value;
    // At once: an effect would wait for the next frame.
    useLayoutEffect(() => void (here || later || fetch()), [here]);
    if (here) return <here.Component {...props} />;
    if (silent) return null;
    const { parts } = messages.value;
    return (
      <div class="hint" role="status">
        <p>{failed.value ? parts.failed : parts.coming}</p>
        {failed.value && (
          <button type="button" onClick={() => void fetch()}>
            {parts.again}
          </button>
        )}
      </div>
    );
  };
  return {
    Part,
    fetch,
    get isAskedFor() {
      return coming !== null;
    },
    get hasFailed() {
      return failed.value;
    },
  };
}
