import { licences } from '../browser/licences.js';
import { messages } from '../messages/index.js';
import './licence-list.css';

/** Line breaks that a text has only because of its own page width. Short lines, such as headings, keep theirs. */
const BROKEN = /(?<=[^\n]{49}[\w,.;"')])\n(?=[\w"'(])/g;

/** The packages in this page, each with its full licence. */
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
