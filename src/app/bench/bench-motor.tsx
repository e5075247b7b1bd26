import { useComputed, useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { CancelButton } from '../ui/form-buttons.js';
import { HoldButton } from '../ui/hold-button.js';
import type { Session } from '../work/session.js';
import type { Bench } from './bench.js';
import { Trim } from './bench-trim.js';
import type { Follow } from './follow.js';

interface MotorProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
}

/** The motor of a class Q timer. Only a button that is held down frees it. */
export function Motor({ session, bench, follow }: MotorProps) {
  const { bench: words, program } = messages.value;
  const isHere = !session.onScreen.apart.value;
  const hasThrottle = isHere && typeof session.editor.working.value?.idleThrottle === 'number';
  const waits = useComputed(() =>
    session.editor.changes.value.some(({ field }) => field.kind === 'idleThrottle'),
  ).value;
  const id = useId();
  return (
    <section class="stack panel">
      <h2>{program.motor}</h2>
      <p class="bad-text" id={id}>
        {words.unlockHint}
      </p>
      <HoldButton
        label={words.unlock}
        holding={words.unlockHold}
        describedBy={id}
        disabled={!bench.ready.value}
        onHeld={() => void bench.unlock()}
      />
      {hasThrottle && (
        <>
          <Trim {...{ session, follow }} field={{ kind: 'idleThrottle' }} name={program.idleThrottle} />
          {waits && <p class="hint">{words.waits}</p>}
        </>
      )}
    </section>
  );
}

/** The jump, whose effect is not documented: the pilot has to confirm it. */
export function Jump({ bench }: { readonly bench: Bench }) {
  const { bench: words } = messages.value;
  const asked = useSignal(false);
  return (
    <section class="stack panel">
      <h2>{words.experimental}</h2>
      <p class="hint">{words.jumpHint}</p>
      <div class="buttons" key={`${asked.value}`}>
        {asked.value && <CancelButton onClick={() => (asked.value = false)} />}
        <button
          type="button"
          disabled={!bench.ready.value}
          onClick={() => {
            if (asked.value) void bench.jump();
            asked.value = !asked.value;
          }}
        >
          {asked.value ? words.jumpSure : words.jump}
        </button>
      </div>
    </section>
  );
}
