import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useLateComputed } from '../ui/use-late.js';
import { EditSheet, useHand } from './edit-sheet.js';
import { ValueField } from './value-field.js';
import './large-figures.css';

/** DT is always in sight, and on Q the motor stop beside it. */
export function LargeFigures({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const { editor } = session;
  const identity = editor.identity.value;
  const hand = useHand();
  const isShort = useLateComputed(() => editor.findings.value.some(({ code }) => code === 'dt-short'), editor.baseline);
  if (!identity) return null;
  return (
    <div class="figures">
      <div class="figure">
        <span class="figure-name">
          {program.dt} {isShort && <strong class="badge loud">{program.shortDt}</strong>}
        </span>
        <ValueField
          session={session}
          field={{ kind: 'time', slot: identity.functions }}
          label={program.dt}
          place="large"
          hand={hand}
        />
      </div>
      {identity.timerClass === 'Q' && (
        <div class="figure">
          <span class="figure-name">{program.motorStop}</span>
          <ValueField
            session={session}
            field={{ kind: 'time', slot: 0 }}
            label={program.motorStop}
            place="large"
            hand={hand}
          />
        </div>
      )}
      <EditSheet {...{ identity, hand }} standing={session.standing} />
    </div>
  );
}
