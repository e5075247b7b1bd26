import { firstSteps } from '../messages/en-guide.js';

/** What a new pilot is told. */
export function FirstStepsPage() {
  return (
    <ol class="stack gap-4">
      {firstSteps.map((step) => (
        <li key={step}>{step}</li>
      ))}
    </ol>
  );
}
