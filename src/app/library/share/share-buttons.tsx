import type { SharedSetting } from '../../../program/index.js';
import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
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

/** Opens the dialog that takes a link. */
export function PasteLinkButton({ sharing }: { readonly sharing: Sharing }) {
  return (
    <button type="button" onClick={() => sharing.paste()}>
      {moreMessages.value.share.paste.title}
    </button>
  );
}
