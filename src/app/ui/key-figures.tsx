import type { TimerProgram } from '../../program/index.js';
import { keyFigures } from '../messages/key-figures.js';
import './key-figures.css';

/** The figures that a pilot looks at first, large: DT, and on class Q the motor stop. */
export function KeyFigures({ program }: { readonly program: TimerProgram }) {
  return (
    <dl class="row figure-list">
      {keyFigures(program).map(({ label, text }) => (
        <div key={label}>
          <dt class="hint">{label}</dt>
          <dd>{text}</dd>
        </div>
      ))}
    </dl>
  );
}
