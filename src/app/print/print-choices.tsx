import { useId } from 'preact/hooks';
import { print as words } from '../messages/en-print.js';
import { Check } from '../ui/check.js';
import { SHEET_PARTS } from './galley.js';
import { PAPERS } from './paper.js';
import type { Print } from './print.js';

/** Chooses the paper, and the parts of the sheet. */
export function PrintChoices({ print }: { readonly print: Print }) {
  const id = useId();
  return (
    <div class="print-choices">
      <fieldset>
        <legend>{words.paper}</legend>
        <div class="print-papers">
          {PAPERS.map((paper) => (
            <label key={paper} class="check">
              <input
                type="radio"
                name={id}
                checked={paper === print.paper.value}
                onChange={() => print.setPaper(paper)}
              />
              {words.papers[paper]}
            </label>
          ))}
        </div>
      </fieldset>
      <fieldset>
        <legend>{words.what}</legend>
        <div class="print-papers">
          {SHEET_PARTS.map((part) => (
            <Check key={part} checked={print.parts.value.has(part)} onChange={() => print.togglePart(part)}>
              {words.parts[part]}
            </Check>
          ))}
        </div>
      </fieldset>
    </div>
  );
}
