import type { ComponentChildren } from 'preact';
import type { Platform } from '../browser/platform.js';
import { ConnectionHelp, connectionSaid } from '../connect/connection-help-view.js';
import { hexOf } from '../messages/hex.js';
import { messages, partText, readable, type Said, timerSaid } from '../messages/index.js';
import type { Keeping } from '../records/keeping.js';
import type { SetAside } from '../records/set-aside.js';
import type { Notice } from '../timer/notices.js';
import { NoticeText } from '../ui/notice-text.js';
import type { Session } from '../work/session.js';
import { AsideNotice, KeepingNotice, RemovedNotice, UpdateNotice } from './keeping-notice.js';
import type { UpdateOffer } from './update-offer.js';

const CALM: ReadonlySet<Notice['code']> = new Set([
  'nothing-chosen',
  'back',
  'kept',
  'write-completed',
  'backed-up',
  'nothing-written',
  'made-laid',
]);

export interface NoticeBarProps {
  readonly session: Session;
  readonly keeping: Keeping;
  readonly aside: SetAside;
  readonly update: UpdateOffer;
  readonly platform: Platform;
  /** What was done with files. */
  readonly fileNotice: ComponentChildren;
  /** Exports the whole library to a file. */
  readonly onExport: () => void;
}

/** What the pilot should know now. The styles show the first, and behind a calm one also the first that is bad. */
export function NoticeBar(props: NoticeBarProps) {
  const { session, keeping, aside, update, platform, fileNotice, onExport } = props;
  const { alike, dismiss, link } = messages.value;
  const notice = session.notices.current.value;
  const part = notice?.kind === 'timer' && notice.details ? partText(notice.details) : null;
  return (
    <div class="notices" role="status">
      <RemovedNotice backups={session.backups} library={session.library} />
      {session.reader.byteOrderOpen.value && session.connection.value && <ByteOrderChoice session={session} />}
      {notice && (
        <div class={CALM.has(notice.code) ? 'notice' : 'notice bad'}>
          <NoticeText said={said(notice, platform, session.standing.value.sure === 'not')} />
          {notice.kind === 'connection' && notice.bytes && (
            <p class="hint">{link.itSaid({ bytes: hexOf(notice.bytes), text: readable(notice.bytes) })}</p>
          )}
          {part && <p>{alike.part({ values: part })}</p>}
          {notice.code === 'select-unanswered' && (
            <button
              type="button"
              disabled={!session.runner.ready.value}
              onClick={() => void session.timer.assume({ bareChecksumRequests: true })}
            >
              {link.trySelectBare}
            </button>
          )}
          {notice.kind === 'connection' && (
            <ConnectionHelp code={notice.code} {...{ platform, info: notice.port, link: session.link }} />
          )}
          <button type="button" class="quiet" onClick={() => session.notices.dismiss()}>
            {dismiss}
          </button>
        </div>
      )}
      {fileNotice}
      <AsideNotice aside={aside} />
      <KeepingNotice keeping={keeping} library={session.library} onExport={onExport} />
      <UpdateNotice update={update} busy={session.runner.busy.value} />
    </div>
  );
}

/** The question that no reading can answer: how the timer writes its times. */
function ByteOrderChoice({ session }: { readonly session: Session }) {
  const { byteOrder } = messages.value;
  return (
    <div class="notice bad">
      <NoticeText said={byteOrder} />
      <div class="buttons">
        {[false, true].map((bigEndianTimes) => (
          <button
            type="button"
            key={bigEndianTimes}
            disabled={session.runner.busy.value}
            onClick={() => void session.timer.assume({ bigEndianTimes })}
          >
            {bigEndianTimes ? byteOrder.exchange : byteOrder.keep}
          </button>
        ))}
      </div>
    </div>
  );
}

/** @param uncertain whether the content of the memory on the screen is uncertain. */
function said(notice: Notice, platform: Platform, uncertain: boolean): Said {
  const { notes } = messages.value;
  if (notice.kind === 'connection') return connectionSaid(notice.code, platform);
  if (notice.kind === 'timer') return timerSaid({ details: {}, ...notice });
  // The result of an interrupted write is not known before a reading.
  return notes[uncertain && notice.code === 'back' ? 'back-uncertain' : notice.code];
}
