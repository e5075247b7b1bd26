import { Icon } from './icon.js';

/** Stands before the name of the place to which a link or a button leads back. */
export function BackSign() {
  return <Icon path="M8 4L2 10L8 16" width={10} />;
}
