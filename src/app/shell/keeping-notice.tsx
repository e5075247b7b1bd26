import type { ReadonlySignal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { saveFile } from '../browser/save-file.js';
import { messages } from '../messages/index.js';
import { countedText } from '../messages/names.js';
import type { Backups } from '../records/backups.js';
import type { Keeping } from '../records/keeping.js';
import type { Library } from '../records/library.js';
import type { SetAside } from '../records/set-aside.js';
import type { UpdateOffer } from './update-offer.js';

interface KeepingNoticeProps {
  readonly keeping: Keeping;
  readonly library: Library;
  /** Exports the whole library to a file. */
  readonly onExport: () => void;
}

/** What this browser does not keep; nothing while all is well. */
export function KeepingNotice({ keeping, library, onExport }: KeepingNoticeProps) {
  const { keeping: words, dismiss } = messages.value;
  const kept = keeping.kept.value;
  const lacks = keeping.lacks.value;
  if ((kept && lacks.length === 0) || keeping.dismissed.value) return null;
  const isNotKept = kept === false || lacks.includes('settings');
  const said = [
    isNotKept && words.notKept,
    kept === null && !isNotKept && words.notKnown,
    lacks.includes('emptied') && words.emptied,
    lacks.includes('tabs') && words.oneTab,
  ].filter(Boolean);
  const mayBeLost = lacks.includes('emptied') || isNotKept || kept === null;
  return (
    <div class="notice bad">
      <p>
        <strong>{words.title}</strong> {said.join(' ')}
      </p>
      {mayBeLost && [library.models, library.settings, library.flights].some(({ list }) => list.value.length > 0) && (
        <button type="button" onClick={onExport}>
          {words.export}
        </button>
      )}
      <button type="button" class="quiet" onClick={() => keeping.dismiss()}>
        {dismiss}
      </button>
    </div>
  );
}

/** Stored data that cannot be read. */
export function AsideNotice({ aside }: { readonly aside: SetAside }) {
  const { aside: words, dismiss } = messages.value;
  if (!aside.isNew.value) return null;
  return (
    <div class="notice bad">
      <p>
        <strong>{words.title({ count: aside.list.value.length })}</strong> {aside.hasWrite && words.write}
      </p>
      <button type="button" onClick={() => saveFile('sidus-set-aside.json', aside.asText())}>
        {words.save}
      </button>
      <button type="button" class="quiet" onClick={() => aside.dismiss()}>
        {dismiss}
      </button>
    </div>
  );
}

interface RemovedNoticeProps {
  readonly library: Library;
  readonly backups: Backups;
}

/** Offers to put back what was just deleted. */
export function RemovedNotice({ library, backups }: RemovedNoticeProps) {
  const { models, settings, flights } = library;
  const count = (list: { readonly removed: ReadonlySignal<readonly unknown[]> }): number => list.removed.value.length;
  const what = { models: count(models), settings: count(settings), flights: count(flights), backups: count(backups) };
  const undo = (): void => {
    library.undoRemove();
    backups.undoRemove();
  };
  return countedText(what) !== '' && <UndoNotice what={countedText(what)} onUndo={undo} />;
}

interface UndoNoticeProps {
  readonly what: string;
  readonly onUndo: () => void;
}

function UndoNotice({ what, onUndo }: UndoNoticeProps) {
  const { removed, undo } = messages.value;
  const button = useRef<HTMLButtonElement>(null);
  useLayoutEffect(
    () => () => {
      // It goes after a press and after a while. The focus must not be lost with it.
      if (button.current === document.activeElement) document.querySelector('main')?.focus({ preventScroll: true });
    },
    [],
  );
  return (
    <div class="notice">
      <p>
        <strong>{removed({ what })}</strong>
      </p>
      <button ref={button} type="button" onClick={onUndo}>
        {undo}
      </button>
    </div>
  );
}

interface UpdateNoticeProps {
  readonly update: UpdateOffer;
  /** Whether bytes move: then the question comes afterwards. */
  readonly busy: boolean;
}

/** Says that a new version is ready; once the pilot has accepted it, what it waits for. */
export function UpdateNotice({ update, busy }: UpdateNoticeProps) {
  const { update: words } = messages.value;
  const take = update.take.value;
  const isWaiting = update.taken.value && !update.free.value;
  if (busy || (!take && !isWaiting)) return null;
  return (
    <div class="notice">
      <p>
        <strong>{words.ready}</strong> {!update.free.value && words.waits}
      </p>
      {take && (
        <button type="button" onClick={take}>
          {words.take}
        </button>
      )}
    </div>
  );
}
