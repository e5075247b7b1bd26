/** Takes the files that are dropped on the page. */
export interface DropTaker {
  /** Whether it would take files now. */
  takes(): boolean;
  /** Called when files are held over the page, and when they no longer are. */
  over(isOver: boolean): void;
  /** Called with the files that were dropped. */
  drop(files: readonly File[]): void;
}

let taker: DropTaker | null = null;
/** The last files that were dropped while nobody could take them. */
let waiting: readonly File[] | null = null;

/**
 * From now on the browser does not leave the page for a dropped file. That must never happen, least of all during a
 * write. Files that are dropped before there is a taker wait for it.
 */
export function holdDroppedFiles(): void {
  // A listener that is added twice still counts once.
  addEventListener('dragover', onOver);
  addEventListener('dragleave', onLeave);
  addEventListener('drop', onDrop);
}

/** @returns a function that ends this: from then on files wait for the next taker. */
export function takeDroppedFiles(next: DropTaker): () => void {
  holdDroppedFiles();
  taker = next;
  const files = waiting;
  waiting = null;
  if (files) next.drop(files);
  return () => {
    if (taker === next) taker = null;
  };
}

function onOver(event: DragEvent): void {
  if (!isFile(event) || isTaken(event)) return;
  event.preventDefault();
  const takes = taker?.takes() ?? true;
  taker?.over(takes);
  if (event.dataTransfer) event.dataTransfer.dropEffect = takes ? 'copy' : 'none';
}

function onLeave(event: DragEvent): void {
  // This event also comes for each element that the pointer leaves on the page.
  if (event.relatedTarget === null) taker?.over(false);
}

function onDrop(event: DragEvent): void {
  if (!isFile(event) || isTaken(event)) return;
  event.preventDefault();
  taker?.over(false);
  const files = [...(event.dataTransfer?.files ?? [])];
  if (!taker) waiting = files;
  else if (taker.takes()) taker.drop(files);
}

/** Whether a part of the page has taken the files, as the line does with a recording. */
function isTaken(event: DragEvent): boolean {
  if (event.defaultPrevented) taker?.over(false);
  return event.defaultPrevented;
}

function isFile(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
