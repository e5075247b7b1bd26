import type { SharedSetting } from '../../../program/index.js';
import { messages } from '../../messages/index.js';
import type { Sharing } from './sharing.js';

interface ShareButtonProps {
  readonly sharing: Sharing;
  /** Called on a click. */
  readonly shared: () => SharedSetting;
}

/** Offers a setting as a link and a QR code. */
export function ShareButton({ sharing, shared }: ShareButtonProps) {
  return (
    <button type="button" onClick={() => sharing.offer(shared())}>
      {messages.value.views.share}
    </button>
  );
}

/** Opens the dialog that reads a QR code or link. */
export function ReadCodeButton({ sharing }: { readonly sharing: Sharing }) {
  return (
    <button type="button" onClick={() => sharing.read()}>
      {messages.value.views.readCode}
    </button>
  );
}
