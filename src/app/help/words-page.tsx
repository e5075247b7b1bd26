import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import './words-page.css';

/** Explains each value of a program, with unit and range. */
export function WordsPage() {
  const { program, edits } = messages.value;
  const { values: words } = moreMessages.value;
  const fields: readonly (readonly [name: string, said: { readonly text: string; readonly range?: string }])[] = [
    [program.slot, words.function],
    [program.time, words.time],
    [edits.table.interval, words.after],
    [words.position.name, words.position],
    [program.motorStop, words.motorStop],
    [program.dt, words.dt],
    [program.idleThrottle, words.idleThrottle],
    [program.memory, words.memory],
  ];
  return (
    <dl class="stack gap-3 ruled words-page">
      {fields.map(([name, { text, range }]) => (
        <div class="stack gap-1" key={name}>
          <dt>{name}</dt>
          <dd>
            <p>{text}</p>
            {range && <p class="hint">{range}</p>}
          </dd>
        </div>
      ))}
    </dl>
  );
}
