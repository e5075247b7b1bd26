import { type ReadonlySignal, signal } from '@preact/signals';
import type { Identity } from '../../protocol/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { type Answers, settledSchema } from '../storage/records.js';
import { kindKey } from './record-keys.js';

/** The name under which the browser keeps it. */
const SETTLED = 'settled';

/** What was settled with timers of each kind. Another walk can find it again, so it is kept as a setting. */
export class Settled {
  readonly #kinds = signal(kept(), { name: 'settled' });
  readonly kinds: ReadonlySignal<ReadonlyMap<string, Answers>> = this.#kinds;

  of(identity: Identity, simulated: boolean): Answers {
    return this.#kinds.value.get(kindKey(identity, simulated)) ?? {};
  }

  keep(identity: Identity, simulated: boolean, answers: Answers): void {
    // Another tab may have kept some of another kind.
    this.#kinds.value = new Map([...this.#kinds.peek(), ...kept()]).set(kindKey(identity, simulated), answers);
    saveSetting(
      SETTLED,
      [...this.#kinds.value].map(([key, each]) => ({ key, answers: each })),
    );
  }
}

function kept(): ReadonlyMap<string, Answers> {
  return new Map((loadSetting(SETTLED, settledSchema) ?? []).map(({ key, answers }) => [key, answers]));
}
