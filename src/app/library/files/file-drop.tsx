import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { takeDroppedFiles } from '../../browser/dropped-files.js';
import { service, tried } from '../../browser/services.js';
import { filesMessages } from '../../messages/en-files.js';
import type { LibraryFiles } from './library-files.js';
import './file-drop.css';

/** Takes files that are dropped on the page, or opened by the system in the installed page. */
export function FileDrop({ files }: { readonly files: LibraryFiles }) {
  const { import: words } = filesMessages;
  const over = useSignal(false);
  useEffect(() => {
    return takeDroppedFiles({
      takes: () => !document.querySelector('dialog[open]'),
      over: (isOver) => {
        over.value = isOver;
      },
      drop: (dropped) => void files.open(dropped),
    });
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

/** The file with which the system has opened the page. A file that the system does not give out counts as none. */
async function openLaunched(files: LibraryFiles, handles: readonly FileSystemHandle[]): Promise<void> {
  const found = await Promise.all(
    handles.map((handle) =>
      'getFile' in handle ? (handle as FileSystemFileHandle).getFile().catch(() => null) : null,
    ),
  );
  await files.open(found.filter((file) => file !== null));
}
