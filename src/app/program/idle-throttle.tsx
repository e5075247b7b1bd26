import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { ValueField } from './value-field.js';

/** The idle throttle, where the timer has told one. */
export function IdleThrottle({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const has = useComputed(() => typeof session.editor.working.value?.idleThrottle === 'number').value;
  if (!has) return null;
  return (
    <div class="figure minor">
      <span class="figure-name">
        {program.idleThrottle} <span class="hint">{program.idleThrottleUnit}</span>
      </span>
      <ValueField
        session={session}
        field={{ kind: 'idleThrottle' }}
        label={program.idleThrottle}
        place="large"
        notesShown
      />
    </div>
  );
}
