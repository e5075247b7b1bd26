import { service, tried } from './services.js';

/**
 * From now on the browser does not leave the page for a dropped file. That must never happen, least of all during a
 * write.
 */
export function holdDroppedFiles(): void {
  addEventListener('dragover', hold);
  addEventListener('drop', hold);
}

/**
 * Takes the files that are dropped on the page while no dialog is open.
 * @returns a function that ends this.
 */
export function takeDroppedFiles(take: (files: readonly File[]) => void): () => void {
  const onDrop = (event: DragEvent): void => {
    if (isFile(event) && !document.querySelector('dialog[open]')) take([...(event.dataTransfer?.files ?? [])]);
  };
  addEventListener('drop', onDrop);
  return () => removeEventListener('drop', onDrop);
}

/** Takes the file with which the system opens the installed page. One that it does not give out counts as none. */
export function takeOpenedFiles(take: (files: readonly File[]) => void): void {
  tried(() =>
    service('launchQueue')?.setConsumer((launch) => {
      const handles = (launch.files ?? []) as readonly FileSystemFileHandle[];
      void Promise.all(handles.map((handle) => handle.getFile?.().catch(() => null))).then((found) =>
        take(found.filter((file) => file instanceof File)),
      );
    }),
  );
}

function hold(event: DragEvent): void {
  if (isFile(event)) event.preventDefault();
}

function isFile(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
