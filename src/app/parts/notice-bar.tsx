import { messages, type Said } from '../messages/index.js';
import { useModels } from '../models.js';
import type { Notice } from '../state/session.js';

const CALM: ReadonlySet<Notice['code']> = new Set([
  'nothing-chosen',
  'edits-restored',
  'edits-kept',
  'edits-set-aside',
]);

/** What the pilot should know now: said once, until it is dismissed or something else is to say. */
export function NoticeBar() {
  const { session, update } = useModels();
  const { dismiss, update: words } = messages.value;
  const notice = session.notice.value;
  const take = update.take.value;
  return (
    <div class="notices" role="status">
      {take && (
        <div class="notice">
          <p>
            <strong>{words.ready}</strong> {session.link.value.status === 'off' ? '' : words.later}
          </p>
          <button type="button" onClick={take}>
            {words.take}
          </button>
        </div>
      )}
      {session.byteOrderOpen.value && session.connection.value && <ByteOrderChoice />}
      {notice && (
        <div class={CALM.has(notice.code) ? 'notice' : 'notice bad'}>
          <NoticeText said={said(notice)} />
          <button type="button" class="quiet" onClick={() => (session.notice.value = null)}>
            {dismiss}
          </button>
        </div>
      )}
    </div>
  );
}

/** What no reading can decide: how the timer writes its times. */
function ByteOrderChoice() {
  const { session } = useModels();
  const { byteOrder } = messages.value;
  return (
    <div class="notice bad">
      <NoticeText said={byteOrder} />
      <div class="buttons">
        <button type="button" disabled={session.busy.value} onClick={() => void session.chooseByteOrder(false)}>
          {byteOrder.keep}
        </button>
        <button type="button" disabled={session.busy.value} onClick={() => void session.chooseByteOrder(true)}>
          {byteOrder.exchange}
        </button>
      </div>
    </div>
  );
}

export function NoticeText({ said: { title, advice } }: { said: Said }) {
  return (
    <p>
      <strong>{title}</strong> {advice}
    </p>
  );
}

function said(notice: Notice): Said {
  const { connection, timer, notes } = messages.value;
  if (notice.kind === 'connection') return connection[notice.code];
  if (notice.kind === 'timer') return timer[notice.code];
  return notes[notice.code];
}
