/** A model in the air. It marks the memory that flies next. */
export function PlaneIcon() {
  return (
    <svg viewBox="0 0 24 24" width="15" height="15" fill="currentColor" aria-hidden="true">
      <path d="M2 13l20-9-7 17-3-7-10-1z" />
    </svg>
  );
}
