import { signal } from '@preact/signals';
import type { ComponentType, FunctionComponent } from 'preact';
import { useLayoutEffect } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { speak } from '../messages/language.js';

/** Gives a file that comes later once its sentences are here: it has some of its own. */
export async function speaking<File>(file: File): Promise<File> {
  await speak();
  return file;
}

/**
 * A file with parts of the page that is loaded after the first picture.
 * @param load imports the file.
 */
export function onDemand<File extends object>(load: () => Promise<File>) {
  const loaded = signal<File | null>(null);
  const failed = signal(false);
  let coming: Promise<void> | null = null;
  /** Loads it. Asked again, it loads nothing twice. */
  const fetch = (): Promise<void> => {
    coming ??= load()
      .then(speaking)
      .then(
        (file) => {
          loaded.value = file;
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
  return {
    /**
     * A part in it. Draws it, or says that it is coming.
     * @param options `silent`: nothing is shown while it is missing, and drawing does not load it, as for a closed
     * dialog: visible parts come first.
     */
    part: <Props extends object>(
      pick: (file: File) => ComponentType<Props>,
      { silent }: { readonly silent: boolean } = { silent: false },
    ): FunctionComponent<Props> =>
      function Part(props) {
        const file = loaded.value;
        // At once: an effect would wait for the next frame.
        useLayoutEffect(() => void (file || silent || fetch()), [file]);
        if (file) {
          const Component = pick(file);
          return <Component {...props} />;
        }
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
      },
    fetch,
    /** Whether it was asked for: it is being loaded, or is here. */
    get isAskedFor() {
      return coming !== null;
    },
    /** Whether it could not be loaded when it was last tried. */
    get hasFailed() {
      return failed.value;
    },
  };
}
