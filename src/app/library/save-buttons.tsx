import { moreMessages } from '../messages/more.js';
import { programOf } from '../messages/names.js';
import type { Session } from '../work/session.js';
import type { SaveSetting } from './save-setting.js';
import './save-buttons.css';

interface SaveButtonsProps {
  readonly session: Session;
  readonly saveSetting: SaveSetting;
  /** Where there is little room: shows only the button that saves the open setting. */
  readonly brief?: boolean;
}

/** Saves the program on the screen: to the setting that it was opened from, or as a new setting. */
export function SaveButtons({ session, saveSetting, brief = false }: SaveButtonsProps) {
  const { save: words } = moreMessages.value.library;
  const { opened, origin } = session;
  const unsaved = opened.unsaved.value;
  const setting = origin.setting.value;
  const undoable = opened.undoable.value;
  if (!session.editor.identity.value) return null;
  const count = (unsaved?.changes ?? 0) + (unsaved?.unreadable ?? 0);
  return (
    <>
      {setting && count > 0 && (
        <button
          type="button"
          class="save-over"
          title={words.state({ name: setting.name, changes: count })}
          onClick={() => void saveSetting.save()}
        >
          {words.over({ program: programOf(setting.name, origin.model.value?.name ?? '') })}
        </button>
      )}
      {/* In the place of the other one. The list of commands has it after further changes, too. */}
      {undoable && count === 0 && (
        <button type="button" class="quiet save-over" onClick={() => opened.undoSave()}>
          {words.undo({ name: undoable.name })}
        </button>
      )}
      {!brief && (
        <button type="button" class="quiet" onClick={() => saveSetting.open()}>
          {setting ? words.asNew : words.open}
        </button>
      )}
    </>
  );
}
