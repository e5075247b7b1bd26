import { useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { media } from '../browser/doors.js';
import { SaveButtons } from '../library/save-buttons.js';
import type { SaveSetting } from '../library/save-setting.js';
import type { Memories } from '../memories/memories.js';
import { messages } from '../messages/index.js';
import { LargeFigures } from '../program/large-figures.js';
import { DtPresets } from '../program/presets.js';
import { ReadButtons } from '../program/read-buttons.js';
import { memoryText } from '../session/memory-names.js';
import type { Preferences } from '../session/preferences.js';
import type { Session } from '../session/session.js';

export interface FiguresPanelProps {
  readonly id: string;
  readonly session: Session;
  readonly memories: Memories;
  readonly preferences: Preferences;
  readonly saveSetting: SaveSetting;
  /**
   * Parts of the strip that have no room there: the memories, and the commands of the connection. A phone has no room
   * for the presets beside its table, either. Null where the strip has room.
   */
  readonly rest: {
    readonly choice: ComponentChildren;
    readonly actions: ComponentChildren;
    readonly isPhone: boolean;
  } | null;
  readonly onClose: () => void;
}

/** The key figures, large enough for a thumb. On a phone also everything that has no room in the strip. */
export function FiguresPanel({ id, session, memories, preferences, saveSetting, rest, onClose }: FiguresPanelProps) {
  const { strip, look, close } = messages.value;
  const identity = session.editor.identity.value;
  // While another memory is being selected, typing would change the one that is left.
  const leavesMemory = session.runner.job.value?.kind === 'select';
  // Figures under the name of another memory would be mistaken for its own, and typing there would change this one.
  const isLooking = memories.looking.value !== null;
  // Not the whole program: with each digit the panel would be drawn again.
  const memory = useComputed(() => session.editor.working.value?.memory ?? null).value;
  const panel = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    // Whoever pressed DT types it next. A finger may want anything in the panel, and keys would come up over it.
    const byTouch = media('(pointer: coarse)')?.matches ?? false;
    if (!byTouch) panel.current?.querySelector<HTMLElement>('.figures input')?.focus({ preventScroll: true });
  }, []);
  if (!identity) return null;
  return (
    <section ref={panel} class="stack gap-3 strip-panel" id={id} aria-label={strip.panel} inert={leavesMemory}>
      {rest?.choice}
      {isLooking ? (
        memory !== null && <p class="hint">{look.lead(memoryText(session, memory))}</p>
      ) : (
        <LargeFigures session={session} />
      )}
      {rest?.isPhone && !isLooking && (
        <>
          <DtPresets editor={session.editor} preferences={preferences} slot={identity.functions} />
          <div class="buttons">
            <ReadButtons session={session} />
            <SaveButtons {...{ session, saveSetting }} />
          </div>
        </>
      )}
      {rest?.actions}
      <button type="button" class="strip-close" onClick={onClose}>
        {close}
      </button>
    </section>
  );
}
