import { useSignal } from '@preact/signals';
import { LIMITS, type Model } from '../../program/index.js';
import { dayText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { FoundModel, Recognition } from '../records/recognition.js';
import type { Candidate } from '../records/recognition-rule.js';
import { CancelButton } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import './model-dialog.css';

/** The pilot says which model it is: one of the list, or a new one. */
export function ModelDialog({ recognition }: { readonly recognition: Recognition }) {
  const { dialog } = moreMessages.value.whichModel.recognition;
  return (
    <Modal open={recognition.choosing.value} title={dialog.title} onEscape={() => recognition.leave()}>
      <Choice recognition={recognition} />
      <NewModel recognition={recognition} />
      <div class="buttons">
        <CancelButton onClick={() => recognition.leave()} />
      </div>
    </Modal>
  );
}

function Choice({ recognition }: { readonly recognition: Recognition }) {
  const { dialog } = moreMessages.value.whichModel.recognition;
  const found = recognition.found.value;
  const possible = possibleOf(found);
  const near = new Map(possible.map((each) => [each.model.id, each]));
  const choices = recognition.choices.value;
  // Likely models come first. Models of another class are not listed.
  const inOrder = [
    ...possible.flatMap(({ model }) => choices.filter(({ id }) => id === model.id)),
    ...choices.filter(({ id }) => !near.has(id)),
  ];
  return (
    <>
      <p class="hint">{found?.kind === 'said' ? dialog.said({ model: found.model.name }) : dialog.lead}</p>
      {found?.kind === 'several' && <p class="hint">{dialog.moreMemories}</p>}
      {inOrder.length === 0 ? (
        <p>{dialog.none}</p>
      ) : (
        <ul class="stack gap-1 model-choices" aria-label={moreMessages.value.library.models.title}>
          {inOrder.map((model) => (
            <Row
              key={model.id}
              model={model}
              near={near.get(model.id) ?? null}
              chosen={found !== null && 'model' in found && found.model.id === model.id}
              onChoose={() => recognition.say(model)}
            />
          ))}
        </ul>
      )}
    </>
  );
}

interface RowProps {
  readonly model: Model;
  /** How well the reading fits this model; null when it says nothing. */
  readonly near: Candidate | null;
  readonly chosen: boolean;
  readonly onChoose: () => void;
}

function Row({ model, near, chosen, onChoose }: RowProps) {
  const { modelBackups: held } = moreMessages.value;
  return (
    <li>
      <button type="button" class="row" aria-pressed={chosen} onClick={onChoose}>
        <strong>{model.name}</strong>
        {near && (
          <small>
            {near.differs === 0
              ? held.same({ when: dayText(near.at) })
              : held.differs({ count: near.differs, when: dayText(near.at) })}
          </small>
        )}
      </button>
    </li>
  );
}

function NewModel({ recognition }: { readonly recognition: Recognition }) {
  const { dialog } = moreMessages.value.whichModel.recognition;
  const name = useSignal('');
  const wanted = name.value.trim();
  return (
    <form
      class="row model-new"
      onSubmit={(event) => {
        event.preventDefault();
        if (wanted !== '') void recognition.sayNew(wanted);
      }}
    >
      <h3>{dialog.newModel}</h3>
      <label class="field">
        <span>{messages.value.label.name}</span>
        <input
          type="text"
          value={name.value}
          maxLength={LIMITS.name}
          autocomplete="off"
          onInput={(event) => (name.value = event.currentTarget.value)}
        />
      </label>
      <button type="submit" disabled={wanted === ''}>
        {dialog.keep}
      </button>
    </form>
  );
}

function possibleOf(found: FoundModel | null): readonly Candidate[] {
  if (!found || found.kind === 'said') return [];
  return 'of' in found ? [found.of] : found.candidates;
}
