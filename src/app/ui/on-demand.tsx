import { signal } from '@preact/signals';
import type { ComponentType, FunctionComponent } from 'preact';
import { useLayoutEffect } from 'preact/hooks';
import { messages } from '../messages/index.js';

/** A part of the page that is fetched after the page was drawn first. */
export interface OnDemand<Props> {
  /** Draws it, or says that it comes. */
  readonly Part: FunctionComponent<Props>;
  /** Whether it was asked for: it comes, or is here. */
  readonly isAskedFor: boolean;
  /** Fetches it; asked again it fetches nothing twice. */
  fetch(): Promise<void>;
}

/**
 * A part of the page that is not needed for the first picture.
 * @param load imports it.
 * @param options with `silent` nothing stands in its place while it is not here, as for a dialog that is shut; with
 * `later` drawing it does not fetch it: what is seen comes first.
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
        // Asked for again it is tried again.
        coming = null;
      },
    );
    return coming;
  };
  const Part: FunctionComponent<Props> = (props) => {
    const here = loaded.value;
    // At once: an effect would wait for a picture that does not show it.
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
  };
}
