/** Stands before the name of the place to which a link or a button leads back. */
export function BackSign() {
  return (
    <svg class="icon" width="10" height="20" aria-hidden="true">
      <path d="M8 4L2 10L8 16" />
    </svg>
  );
}
