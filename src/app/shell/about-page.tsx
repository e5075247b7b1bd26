import { version } from '../browser/version.js';
import type { Installation } from '../connect/installation.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { UpdateOffer } from './update-offer.js';

/** Needs a network, as the new version did. */
const CHANGES = 'https://github.com/sidus-timer/sidus-timer/blob/main/CHANGELOG.md';
/** The build puts it beside the page. */
const LICENCES = 'LICENSES.txt';

interface AboutPageProps {
  readonly installation: Installation;
  readonly update: UpdateOffer;
}

/** The version, whether it works without a network, what is new in it, and the work of others in it. */
export function AboutPage({ installation, update }: AboutPageProps) {
  const { update: updateWords, start } = messages.value;
  const { aboutPage: words } = moreMessages.value;
  const install = installation.install.value;
  const take = update.take.value;
  return (
    <section class="stack setting">
      <h2>{words.title}</h2>
      <p>
        {words.version({ version })} {installation.ready.value ? words.offline : words.notOffline}
      </p>
      <p>
        <a href={CHANGES} target="_blank" rel="noreferrer">
          {updateWords.news}
        </a>{' '}
        <a href={LICENCES} target="_blank" rel="noreferrer">
          {words.licences}
        </a>
      </p>
      <div class="buttons">
        {take && (
          <button type="button" onClick={take}>
            {updateWords.take}
          </button>
        )}
        {install && (
          <button type="button" onClick={install}>
            {start.install}
          </button>
        )}
      </div>
    </section>
  );
}
