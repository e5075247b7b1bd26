import { libraryMessages } from '../messages/en-library.js';
import type { Session } from '../session/session.js';
import type { SaveSetting } from './save-setting.js';

interface SaveButtonsProps {
  readonly session: Session;
  readonly saveSetting: SaveSetting;
  /** Where there is little room: shows only the button that saves the open setting. */
  readonly brief?: boolean;
}

/** Saves the program on the screen: to the setting that it was opened from, or as a new setting. */
export function SaveButtons({ session, saveSetting, brief = false }: SaveButtonsProps) {
  const { save: words } = libraryMessages;
  const { opened } = session;
  const unsaved = opened.unsaved.value;
  const setting = opened.shown.value?.setting ?? null;
  if (!session.editor.identity.value) return null;
  const count = (unsaved?.changes ?? 0) + (unsaved?.unreadable ?? 0);
  return (
    <>
      {setting && count > 0 && (
        <button
          type="button"
          title={words.state(setting.name, unsaved?.changes ?? 0, unsaved?.unreadable ?? 0)}
          onClick={() => void saveSetting.save()}
        >
          {words.again}
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
