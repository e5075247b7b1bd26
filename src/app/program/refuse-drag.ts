/**
 * A field gives its text to no drag and takes none: both would change a value without a key being pressed, and one that
 * is carried from field to field changes two. Spread it on what surrounds the field.
 */
export const refuseDrag = {
  onDragStart: (event: DragEvent): void => event.preventDefault(),
  onDragOver: refuse,
  onDrop: refuse,
};

function refuse(event: DragEvent): void {
  event.preventDefault();
  if (event.dataTransfer) event.dataTransfer.dropEffect = 'none';
}
