import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { HoldButton } from '../ui/hold-button.js';
import type { Bench } from './bench.js';
import './bench-motor.css';

interface MotorProps {
  readonly bench: Bench;
  readonly children?: ComponentChildren;
}

/** The motor of a class Q timer, which is freed only by a button that is held. */
export function Motor({ bench, children }: MotorProps) {
  const { bench: words } = messages.value;
  const id = useId();
  return (
    <section class="bench-motor">
      <h2>{words.motor}</h2>
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
      {children}
    </section>
  );
}

/** What is not documented, asked for twice. */
export function Jump({ bench }: { readonly bench: Bench }) {
  const { bench: words } = messages.value;
  const asked = useSignal(false);
  return (
    <section class="bench-motor">
      <h2>{words.experimental}</h2>
      <p class="hint">{words.jumpHint}</p>
      <div class="buttons">
        {asked.value ? (
          <>
            <button
              type="button"
              disabled={!bench.ready.value}
              onClick={() => {
                asked.value = false;
                void bench.jump();
              }}
            >
              {words.jumpSure}
            </button>
            <button
              type="button"
              onClick={() => {
                asked.value = false;
              }}
            >
              {words.cancel}
            </button>
          </>
        ) : (
          <button
            type="button"
            disabled={!bench.ready.value}
            onClick={() => {
              asked.value = true;
            }}
          >
            {words.jump}
          </button>
        )}
      </div>
    </section>
  );
}
