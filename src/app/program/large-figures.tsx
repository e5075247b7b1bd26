import { useComputed } from '@preact/signals';
import { fieldKey } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { keyFields } from '../messages/key-figures.js';
import type { Session } from '../session/session.js';
import { EditSheet, useHand } from './edit-sheet.js';
import { ValueField } from './value-field.js';
import './large-figures.css';

/** DT is always in sight, and on Q the motor stop beside it. */
export function LargeFigures({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const { editor } = session;
  const identity = editor.identity.value;
  const hand = useHand();
  const isShort = useComputed(() => editor.findings.value.some(({ code }) => code === 'dt-short')).value;
  if (!identity) return null;
  return (
    <div class="figures">
      {keyFields(identity).map((field, at) => {
        // DT comes first.
        const name = at === 0 ? program.dt : program.motorStop;
        return (
          <div class="figure" key={fieldKey(field)}>
            <span class="figure-name">
              {name} {at === 0 && isShort && <strong class="badge loud">{program.shortDt}</strong>}
            </span>
            <ValueField {...{ session, field, hand }} label={name} place="large" />
          </div>
        );
      })}
      <EditSheet {...{ identity, hand }} standing={session.standing} />
    </div>
  );
}
