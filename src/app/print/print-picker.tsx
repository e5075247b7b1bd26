import { useEffect, useMemo } from 'preact/hooks';
import { dotted } from '../messages/dotted.js';
import { dateText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { Check } from '../ui/check.js';
import { memoryOf } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import type { Print } from './print.js';
import { memoryKey, ON_SCREEN } from './print-order.js';

interface PrintPickerProps {
  readonly session: Session;
  readonly print: Print;
}

/** Chooses what to print: saved programs, the one on the screen, and memories of the timer. */
export function PrintPicker({ session, print }: PrintPickerProps) {
  const { library, editor, standings, origin } = session;
  const { order } = print;
  const { value: chosen } = order.keys;
  const { knowledge, noModel } = messages.value;
  useEffect(() => void library.load(), [library]);
  // With nothing to print, this is the next step.
  const isFirst = useMemo(() => print.sheets.peek().length === 0, [print]);
  const memories = standings.readMemories().map(({ memory, known }) => {
    const read = known.state === 'read' ? knowledge.lastReadAt({ time: dateText(known.at) }) : knowledge.lastRead;
    return { key: memoryKey(memory), name: dotted([memoryOf(origin.timer.value, memory), read]) };
  });
  const models = library.models.list.value;
  const kept = library.settings.list.value
    .map(({ key, setting }) => {
      const at = models.findIndex((each) => each.key === setting.model);
      const name = dotted([models[at]?.model.name ?? noModel, setting.name]);
      return { key, name, place: at < 0 ? models.length : at };
    })
    .sort((a, b) => a.place - b.place);
  const screen = { key: ON_SCREEN, name: moreMessages.value.compare.screen };
  const choices = [...(editor.working.value ? [screen] : []), ...memories, ...kept];
  return (
    <details class="print-picker" open={isFirst}>
      <summary>{moreMessages.value.print.choose({ chosen: print.sheets.value.length })}</summary>
      <div class="print-list">
        {choices.map(({ key, name }) => (
          <Check key={key} checked={chosen.includes(key)} onChange={() => order.toggle(key)}>
            {name}
          </Check>
        ))}
      </div>
      {chosen.length > 1 && (
        <button type="button" class="quiet" onClick={() => order.clear()}>
          {moreMessages.value.print.clear}
        </button>
      )}
    </details>
  );
}
