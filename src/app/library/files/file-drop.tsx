import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { service, tried } from '../../browser/services.js';
import { filesMessages } from '../../messages/files.js';
import type { LibraryFiles } from './library-files.js';
import './file-drop.css';

/**
 * Takes files that are dropped on the page, or opened by the system in the installed page. A browser would leave the
 * page for a file that is dropped anywhere else: with a write under way that must not happen.
 */
export function FileDrop({ files }: { readonly files: LibraryFiles }) {
  const { import: words } = filesMessages.value;
  const over = useSignal(false);
  useEffect(() => {
    const isFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
    const takes = (): boolean => !document.querySelector('dialog[open]');
    const onOver = (event: DragEvent): void => {
      if (!isFile(event)) return;
      event.preventDefault();
      over.value = takes();
      if (event.dataTransfer) event.dataTransfer.dropEffect = takes() ? 'copy' : 'none';
    };
    const onLeave = (event: DragEvent): void => {
      // It also leaves each part of the page that it passes over.
      if (event.relatedTarget === null) over.value = false;
    };
    const onDrop = (event: DragEvent): void => {
      if (!isFile(event)) return;
      event.preventDefault();
      over.value = false;
      if (takes()) void files.open([...(event.dataTransfer?.files ?? [])]);
    };
    addEventListener('dragover', onOver);
    addEventListener('dragleave', onLeave);
    addEventListener('drop', onDrop);
    return () => {
      removeEventListener('dragover', onOver);
      removeEventListener('dragleave', onLeave);
      removeEventListener('drop', onDrop);
    };
  }, [files, over]);
  useEffect(() => {
    tried(() => service('launchQueue')?.setConsumer((launch) => void openLaunched(files, launch.files ?? [])));
  }, [files]);
  return over.value ? (
    <div class="file-drop" aria-hidden="true">
      <p>{words.drop}</p>
    </div>
  ) : null;
}

/** What the system has opened the page with; a file that it does not hand out is none. */
async function openLaunched(files: LibraryFiles, handles: readonly FileSystemHandle[]): Promise<void> {
  const found = await Promise.all(
    handles.map((handle) =>
      'getFile' in handle ? (handle as FileSystemFileHandle).getFile().catch(() => null) : null,
    ),
  );
  await files.open(found.filter((file) => file !== null));
}
