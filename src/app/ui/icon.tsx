interface IconProps {
  readonly path: string;
  readonly width?: number;
  readonly height?: number;
}

/** A simple line drawing, for the eye only. In pixels. */
export function Icon({ path, width = 20, height = 20 }: IconProps) {
  return (
    <svg class="icon" width={width} height={height} aria-hidden="true">
      <path d={path} />
    </svg>
  );
}
