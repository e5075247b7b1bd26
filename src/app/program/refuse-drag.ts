/**
 * Props that stop a field from giving or taking text by drag and drop: both would change values without a key press,
 * and a drag from field to field would change two. Spread them on an element around the field.
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
