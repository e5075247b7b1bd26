import type { Release } from '../browser/update-news.js';
import { messages } from '../messages/index.js';
import './release-list.css';

/** What is new, release by release. */
export function ReleaseList({ releases }: { readonly releases: readonly Release[] }) {
  const { update: words } = messages.value;
  return (
    <div class="releases">
      {releases.map(({ version, changes }) => (
        <section key={version}>
          <h3>{words.version(version)}</h3>
          {changes.map(({ title, items }) => (
            <div key={title}>
              <h4>{title}</h4>
              <ul>
                {items.map((item) => (
                  <li key={item}>{item}</li>
                ))}
              </ul>
            </div>
          ))}
        </section>
      ))}
    </div>
  );
}
