import { firstSteps as words } from '../messages/en-guide.js';
import { type FirstSteps, STEPS } from './first-steps.js';
import './first-steps-card.css';

/** The first steps, one at a time, below Connect. */
export function FirstStepsCard({ steps }: { readonly steps: FirstSteps }) {
  const shown = steps.shown.value;
  if (shown === null) return null;
  const at = STEPS.indexOf(shown);
  const { title, text } = words.steps[shown];
  const isLast = at === STEPS.length - 1;
  return (
    <section class="first-steps" aria-labelledby="first-steps-title">
      <div aria-live="polite">
        <p class="hint">{words.of(at + 1, STEPS.length)}</p>
        <h2 id="first-steps-title">{title}</h2>
        <p>{text}</p>
      </div>
      <div class="buttons">
        {!isLast && (
          <button type="button" class="quiet" onClick={() => steps.end()}>
            {words.skip}
          </button>
        )}
        {at > 0 && (
          <button type="button" onClick={() => steps.show(STEPS[at - 1])}>
            {words.back}
          </button>
        )}
        <button type="button" onClick={() => steps.show(STEPS[at + 1])}>
          {isLast ? words.done : words.next}
        </button>
      </div>
    </section>
  );
}

/** All first steps, to read again. */
export function FirstStepsPage() {
  return (
    <ol class="steps-page">
      {STEPS.map((step) => (
        <li key={step}>
          <h3>{words.steps[step].title}</h3>
          <p>{words.steps[step].text}</p>
        </li>
      ))}
    </ol>
  );
}
