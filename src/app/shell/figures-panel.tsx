import type { ComponentChildren } from 'preact';
import { SaveButtons } from '../library/save-buttons.js';
import type { SaveSetting } from '../library/save-setting.js';
import type { Memories } from '../memories/memories.js';
import { messages } from '../messages/index.js';
import { DtPresets } from '../program/presets.js';
import { ReadButtons } from '../program/read-buttons.js';
import type { Preferences } from '../records/preferences.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';

export interface FiguresPanelProps {
  readonly id: string;
  readonly session: Session;
  readonly memories: Memories;
  readonly preferences: Preferences;
  readonly saveSetting: SaveSetting;
  /**
   * Parts of the strip that have no room there: the memories, and the commands of the connection. A phone has no room
   * for the presets beside its table, either.
   */
  readonly rest: {
    readonly choice: ComponentChildren;
    readonly actions: ComponentChildren;
    readonly isPhone: boolean;
  };
  readonly onClose: () => void;
}

/** Everything that has no room in the strip. */
export function FiguresPanel({ id, session, memories, preferences, saveSetting, rest, onClose }: FiguresPanelProps) {
  const { strip, look, close } = messages.value;
  const identity = session.editor.identity.value;
  // While another memory is being selected, typing would change the one that is left.
  const leavesMemory = session.runner.job.value?.kind === 'select';
  // Figures under the name of another memory would be mistaken for its own, and typing there would change this one.
  const isLooking = memories.looking.value !== null;
  const memory = session.nextFlight.memory.value;
  if (!identity) return null;
  return (
    <section class="stack gap-3 strip-panel" id={id} aria-label={strip.panel} inert={leavesMemory}>
      {rest.choice}
      {isLooking && memory !== null && <p class="hint">{look.lead({ current: memoryText(session, memory) })}</p>}
      {rest.isPhone && !isLooking && (
        <>
          <DtPresets editor={session.editor} preferences={preferences} slot={identity.functions} />
          <div class="buttons">
            <ReadButtons session={session} />
            <SaveButtons {...{ session, saveSetting }} />
          </div>
        </>
      )}
      {rest.actions}
      <button type="button" class="strip-close" onClick={onClose}>
        {close}
      </button>
    </section>
  );
}
