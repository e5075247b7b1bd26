import { licences } from '../browser/licences.js';
import { messages } from '../messages/index.js';
import './licence-list.css';

/** Where a text breaks its lines for a page of its own width. Its short lines are meant, such as a heading. */
const BROKEN = /(?<=[^\n]{49}[\w,.;"')])\n(?=[\w"'(])/g;

/** The packages that the page is made with, each with its licence in full. */
export function LicenceList() {
  const { aboutPage: words } = messages.value;
  return (
    <ul class="licences">
      {licences.map(({ name, version, licence, text }) => (
        <li key={name}>
          <details>
            <summary>{words.package(name, version, licence)}</summary>
            <p>{text.replace(BROKEN, ' ')}</p>
          </details>
        </li>
      ))}
    </ul>
  );
}
