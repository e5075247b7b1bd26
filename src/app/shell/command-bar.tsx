import { useRef } from 'preact/hooks';
import type { ProgramField } from '../../program/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { FollowNote } from '../bench/follow-panel.js';
import { SaveButtons } from '../library/save-buttons.js';
import type { SaveSetting } from '../library/save-setting.js';
import { messages } from '../messages/index.js';
import { ReadButtons } from '../program/read-buttons.js';
import { UndoButtons } from '../program/undo-buttons.js';
import { BlockedNote, WriteButton } from '../program/write-button.js';
import { useHeight } from '../ui/use-height.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from '../write/write-job.js';
import './command-bar.css';

export interface CommandBarProps {
  readonly session: Session;
  readonly write: WriteJob;
  readonly bench: Bench;
  readonly follow: Follow;
  readonly saveSetting: SaveSetting;
  /** Goes to a field of the table. */
  readonly onField: (field: ProgramField) => void;
  /** Opens the tools that shift the present row and all later ones; null when there is no room for them. */
  readonly onShift: (() => void) | null;
  /** When the picture has no room beside the table: whether it is shown in place of the table. */
  readonly picture: { readonly open: boolean; readonly onToggle: () => void } | null;
}

/** How the program differs from the timer, and the commands to write, read and undo. */
export function CommandBar({ session, write, bench, follow, saveSetting, onField, onShift, picture }: CommandBarProps) {
  const { program, edits } = messages.value;
  const { editor } = session;
  const bar = useRef<HTMLElement>(null);
  // The buttons of a phone are a little higher.
  useHeight(bar, '--bar', picture ? 53 : 52);
  return (
    <section class="row actions" ref={bar}>
      <FollowNote session={session} bench={bench} follow={follow} />
      <BlockedNote editor={editor} />
      <UndoButtons session={session} write={write} />
      {onShift && (
        <button type="button" class="quiet" onClick={onShift}>
          {edits.shift.open}
        </button>
      )}
      {picture && (
        <button type="button" class="quiet" aria-pressed={picture.open} onClick={picture.onToggle}>
          {picture.open ? program.table : program.picture}
        </button>
      )}
      <SaveButtons {...{ session, saveSetting }} brief={picture !== null} />
      <div class="buttons">
        {/* On a phone they stand below the large figures. */}
        {!picture && <ReadButtons session={session} />}
        <WriteButton {...{ session, write, onField }} brief={picture !== null} />
      </div>
    </section>
  );
}
