import { useId, useMemo } from 'preact/hooks';
import type { SharedSetting } from '../../../program/index.js';
import { canSend, send } from '../../browser/share-sheet.js';
import { messages } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { CopyButton } from '../../ui/copy-button.js';
import { QrCode } from '../../ui/qr-code.js';
import { linkOf, qrLinkOf } from '../../work/setting-link.js';
import type { Sharing } from './sharing.js';
import './offer.css';

interface OfferProps {
  readonly sharing: Sharing;
  readonly shared: SharedSetting;
  /** The address of this page. */
  readonly page: string;
}

/** A setting as a link, and as a QR code for another device nearby. */
export function SettingOffer({ sharing, shared, page }: OfferProps) {
  const { offer: words } = moreMessages.value.share;
  const id = useId();
  const link = useMemo(() => linkOf(shared, page), [shared, page]);
  const qr = useMemo(() => qrLinkOf(shared, page), [shared, page]);
  return (
    <>
      <div class="share-offer">
        <div class="stack gap-3">
          <p>{words.lead}</p>
          {qr ? <p>{words.scan}</p> : <p class="hint">{words.tooLong}</p>}
        </div>
        {qr && <QrCode text={qr.link} label={words.qr({ name: shared.name })} />}
        <div class="field">
          <label for={id}>{words.link}</label>
          <input
            id={id}
            type="text"
            readOnly
            value={link}
            onFocus={({ currentTarget }) => currentTarget.select()}
            spellcheck={false}
          />
          <div class="buttons">
            <CopyButton label={words.copy} text={() => link} />
            {canSend() && (
              <button type="button" onClick={() => void send({ title: shared.name, url: link })}>
                {messages.value.views.share}
              </button>
            )}
          </div>
          {qr?.isCut && <p class="hint">{words.cut}</p>}
        </div>
      </div>
      <div class="buttons">
        <button type="button" onClick={() => sharing.close()}>
          {messages.value.close}
        </button>
      </div>
    </>
  );
}
