import { licences } from '../browser/licences.js';
import { messages } from '../messages/index.js';
import './licence-list.css';

/** The packages that the page is made with, each with its licence in full. */
export function LicenceList() {
  const { aboutPage: words } = messages.value;
  return (
    <ul class="licences">
      {licences.map(({ name, version, licence, text }) => (
        <li key={name}>
          <details>
            <summary>{words.package(name, version, licence)}</summary>
            <p>{text}</p>
          </details>
        </li>
      ))}
    </ul>
  );
}
