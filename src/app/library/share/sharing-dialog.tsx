import { type ReadonlySignal, useComputed } from '@preact/signals';
import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { Modal } from '../../ui/modal.js';
import type { Session } from '../../work/session.js';
import { SettingOffer } from './offer.js';
import { PasteLink } from './paste-link.js';
import { ReceivedSetting } from './received-setting.js';
import type { Sharing } from './sharing.js';

interface SharingDialogProps {
  readonly session: Session;
  readonly sharing: Sharing;
  /** Another question that is open now: a link that comes in waits for it. */
  readonly asked: ReadonlySignal<unknown>;
  /** The address of this page. */
  readonly page: string;
  /** Shows the program that was opened. */
  readonly onProgram: () => void;
  /** Shows a setting of the library, by its model and its key. */
  readonly onLibrary: (model: string | null, key: string) => void;
}

/** Sends a setting to another device, or receives one. */
export function SharingDialog({ session, sharing, asked, page, onProgram, onLibrary }: SharingDialogProps) {
  // The dialog must not interrupt: it waits while bytes move, and while another question is open.
  const isFree = useComputed(() => !session.runner.busy.value && asked.value === null);
  const current = sharing.current.value;
  const title =
    current?.step === 'offer'
      ? messages.value.views.share
      : current?.step === 'paste'
        ? moreMessages.value.share.paste.title
        : moreMessages.value.share.received.title;
  return (
    <Modal open={current !== null && isFree.value} key={current?.step} title={title} onEscape={() => sharing.close()}>
      {current?.step === 'offer' && <SettingOffer sharing={sharing} shared={current.shared} page={page} />}
      {current?.step === 'paste' && <PasteLink sharing={sharing} />}
      {current?.step === 'received' && (
        <ReceivedSetting key={current.link} {...{ session, sharing, onProgram, onLibrary }} link={current.link} />
      )}
    </Modal>
  );
}
