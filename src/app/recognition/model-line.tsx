import { eitherOf } from '../messages/either.js';
import { dayText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { FoundModel, Recognition } from '../records/recognition.js';
import type { Candidate } from '../records/recognition-rule.js';
import './model-line.css';

/** How many candidates have a button. All of them are named. */
const BUTTONS = 3;

/** Which model the timer belongs to, if its content shows it; otherwise the question to the pilot. */
export function ModelLine({ recognition }: { readonly recognition: Recognition }) {
  const { recognition: words } = moreMessages.value.whichModel;
  const found = recognition.found.value;
  if (!found || found.kind === 'said' || !recognition.tells.value) return null;
  const picks = picksOf(found);
  return (
    <div class="notices">
      <div class="notice model-line">
        <p>{saidOf(found)}</p>
        <div class="buttons">
          {picks.slice(0, BUTTONS).map(({ model }) => (
            <button type="button" key={model.id} onClick={() => recognition.say(model)}>
              {found.kind === 'like' ? words.yes({ model: model.name }) : model.name}
            </button>
          ))}
          <button
            type="button"
            class={picks.length > 0 || found.kind === 'same' ? 'quiet' : ''}
            onClick={() => recognition.choose()}
          >
            {words.choose}
          </button>
          <button type="button" class={found.kind === 'same' ? '' : 'quiet'} onClick={() => recognition.notNow()}>
            {found.kind === 'same' ? words.ok : messages.value.notNow}
          </button>
        </div>
      </div>
    </div>
  );
}

/** The sentence to show. */
function saidOf(found: Exclude<FoundModel, { kind: 'said' }>): string {
  const { recognition: words } = moreMessages.value.whichModel;
  if (found.kind === 'same') return words.same({ model: found.model.name, when: dayText(found.of.at) });
  if (found.kind === 'like') return words.like({ model: found.model.name, count: found.of.differs });
  return found.kind === 'several'
    ? words.several({ models: eitherOf(found.candidates.map(({ model }) => model.name)) })
    : words.unknown;
}

/** The models that one press can choose. */
function picksOf(found: Exclude<FoundModel, { kind: 'said' }>): readonly Candidate[] {
  if ('candidates' in found) return found.candidates;
  return found.kind === 'like' ? [found.of] : [];
}
