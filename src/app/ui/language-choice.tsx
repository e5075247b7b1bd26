import { useSignal } from '@preact/signals';
import { chooseLanguage, LANGUAGES, languageName } from '../messages/first.js';
import { messages } from '../messages/index.js';
import { language } from '../messages/language.js';
import { Select } from './choice.js';

/** The language of the page, each by its own name: who cannot read the page finds it by that. */
export function LanguageChoice() {
  const { label, parts } = messages.value;
  const failed = useSignal(false);
  const choose = (code: string): void => {
    // Drawn again after each failure, so that the list shows what is spoken, and the same one can be chosen again.
    failed.value = false;
    chooseLanguage(code).catch(() => (failed.value = true));
  };
  return (
    <span class="row language-choice">
      <Select
        name={label.language}
        choices={LANGUAGES}
        nameOf={languageName}
        chosen={language.value}
        onChoose={choose}
      />
      {failed.value && <span role="alert">{parts.failed}</span>}
    </span>
  );
}
