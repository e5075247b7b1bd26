import { firstSteps } from '../messages/en-guide.js';
import './first-steps-page.css';

/** What a new pilot is told. */
export function FirstStepsPage() {
  return (
    <ol class="stack gap-4 steps-page">
      {firstSteps.map((step) => (
        <li key={step}>{step}</li>
      ))}
    </ol>
  );
}
