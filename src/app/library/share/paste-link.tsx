import { useSignal } from '@preact/signals';
import { moreMessages } from '../../messages/more.js';
import { FormButtons } from '../../ui/form-buttons.js';
import { Problem } from '../../ui/problem.js';
import { holdsLink, type Sharing } from './sharing.js';

/** Takes a link to a saved program, or the message that it is in. */
export function PasteLink({ sharing }: { readonly sharing: Sharing }) {
  const { paste: words, offer } = moreMessages.value.share;
  const text = useSignal('');
  const isWrong = useSignal(false);
  return (
    <form
      class="stack"
      onSubmit={(event) => {
        event.preventDefault();
        isWrong.value = !holdsLink(text.value);
        if (!isWrong.value) sharing.take(text.value);
      }}
    >
      <p>{words.lead}</p>
      <label class="field">
        <span>{offer.link}</span>
        <input
          type="text"
          value={text.value}
          autofocus
          autocomplete="off"
          spellcheck={false}
          onInput={({ currentTarget }) => {
            text.value = currentTarget.value;
            isWrong.value = false;
          }}
        />
      </label>
      <Problem text={isWrong.value && words.notLink} />
      <FormButtons label={words.show} disabled={text.value.trim() === ''} onCancel={() => sharing.close()} />
    </form>
  );
}
