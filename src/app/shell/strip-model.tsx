import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import './strip-model.css';

/** The name of the model, as a button to choose another one. */
export function StripModel({ session }: { readonly session: Session }) {
  const { recognition: words } = messages.value;
  const { recognition, origin } = session;
  const model = origin.timer.value;
  if (session.connection.value === null) return null;
  // Not before the models are loaded and something was read.
  if (!model && recognition.found.value === null) return null;
  return (
    <button
      type="button"
      class="quiet strip-model"
      aria-haspopup="dialog"
      aria-label={model ? words.change({ model: model.name }) : undefined}
      onClick={() => recognition.choose()}
    >
      <span key={model?.id} class={model ? 'strip-model-name' : ''}>
        {model?.name ?? words.which}
      </span>
    </button>
  );
}
