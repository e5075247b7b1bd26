import type { ComponentChildren } from 'preact';
import { SaveButtons } from '../library/save-buttons.js';
import type { SaveSetting } from '../library/save-setting.js';
import { messages } from '../messages/index.js';
import { LargeFigures } from '../program/large-figures.js';
import { DtPresets } from '../program/presets.js';
import { ReadButtons } from '../program/read-buttons.js';
import type { Preferences } from '../session/preferences.js';
import type { Session } from '../session/session.js';

export interface FiguresPanelProps {
  readonly id: string;
  readonly session: Session;
  readonly preferences: Preferences;
  readonly saveSetting: SaveSetting;
  /**
   * Parts of the strip that have no room on a phone: the memories, and the commands of the connection. Null where the
   * strip has room.
   */
  readonly rest: { readonly choice: ComponentChildren; readonly actions: ComponentChildren } | null;
  readonly onClose: () => void;
}

/** The key figures, large enough for a thumb. On a phone also everything that has no room in the strip. */
export function FiguresPanel({ id, session, preferences, saveSetting, rest, onClose }: FiguresPanelProps) {
  const { strip } = messages.value;
  const identity = session.editor.identity.value;
  // While another memory is being selected, typing would change the one that is left.
  const leavesMemory = session.runner.job.value?.kind === 'select';
  if (!identity) return null;
  return (
    <section class="strip-panel" id={id} aria-label={strip.panel} inert={leavesMemory}>
      {rest?.choice}
      <LargeFigures session={session} />
      {rest?.actions && (
        <>
          <DtPresets editor={session.editor} preferences={preferences} slot={identity.functions} />
          <div class="buttons">
            <ReadButtons session={session} />
            <SaveButtons {...{ session, saveSetting }} />
          </div>
          {rest.actions}
        </>
      )}
      <button type="button" class="strip-close" onClick={onClose}>
        {strip.close}
      </button>
    </section>
  );
}
