/** Who takes the files that are dropped on the page. */
export interface DropTaker {
  /** Whether it would take some now. */
  takes(): boolean;
  /** Files are held over the page, or no longer. */
  over(isOver: boolean): void;
  /** They were dropped. */
  drop(files: readonly File[]): void;
}

let taker: DropTaker | null = null;
/** What was dropped last while nobody was there to take it. */
let waiting: readonly File[] | null = null;

/**
 * Keeps the browser from leaving the page for a file that is dropped on it, from now on: with a write under way that
 * must not happen, nor in the first moment. What is dropped before there is a taker waits for it.
 */
export function holdDroppedFiles(): void {
  // Added again they would not be added twice.
  addEventListener('dragover', onOver);
  addEventListener('dragleave', onLeave);
  addEventListener('drop', onDrop);
}

/** @returns what ends it: from then on files wait for the next taker. */
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
  // It also leaves each part of the page that it passes over.
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

/** Whether a part of the page has taken it, as the line does with a recording. */
function isTaken(event: DragEvent): boolean {
  if (event.defaultPrevented) taker?.over(false);
  return event.defaultPrevented;
}

function isFile(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
