import { type ReadonlySignal, useComputed } from '@preact/signals';
import { share } from '../../messages/en-share.js';
import type { Session } from '../../session/session.js';
import { Modal } from '../../ui/modal.js';
import { SettingOffer } from './offer.js';
import { ReadCode } from './read-code.js';
import { ReceivedSetting } from './received-setting.js';
import type { Sharing } from './sharing.js';

interface SharingDialogProps {
  readonly session: Session;
  readonly sharing: Sharing;
  /** Something else is asked just now: what came by link waits. */
  readonly asked: ReadonlySignal<unknown>;
  /** The address of this page. */
  readonly page: string;
  /** What was opened is to be seen. */
  readonly onProgram: () => void;
  /** A setting of the library is to be seen, by its model and its key. */
  readonly onLibrary: (model: string | null, key: string) => void;
}

/** A setting on its way to another device, or from one. */
export function SharingDialog({ session, sharing, asked, page, onProgram, onLibrary }: SharingDialogProps) {
  const { offer, received, read } = share;
  // It is asked in the middle of nothing: not while bytes move, and not over another question.
  const isFree = useComputed(() => !session.runner.busy.value && asked.value === null);
  const current = sharing.current.value;
  const title =
    current?.step === 'offer'
      ? offer.title(current.shared.name)
      : current?.step === 'read'
        ? read.title
        : received.title;
  return (
    <Modal
      open={current !== null && isFree.value}
      key={current?.step}
      title={title}
      titleId="sharing-title"
      held={false}
      onEscape={() => sharing.close()}
    >
      {current?.step === 'offer' && <SettingOffer sharing={sharing} shared={current.shared} page={page} />}
      {current?.step === 'read' && <ReadCode sharing={sharing} />}
      {current?.step === 'received' && (
        <ReceivedSetting key={current.link} {...{ session, sharing, onProgram, onLibrary }} link={current.link} />
      )}
    </Modal>
  );
}
