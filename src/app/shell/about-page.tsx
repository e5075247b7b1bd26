import { useSignal } from '@preact/signals';
import { news } from '../browser/news.js';
import type { Installation } from '../connect/installation.js';
import { messages } from '../messages/index.js';
import { licenceList } from './licence-part.js';
import { ReleaseList } from './release-list.js';
import type { UpdateOffer } from './update-offer.js';

interface AboutPageProps {
  readonly installation: Installation;
  readonly update: UpdateOffer;
}

/** The version, what is new in it, whether it works without a network, and the work of others in it. */
export function AboutPage({ installation, update }: AboutPageProps) {
  const { aboutPage: words, update: updateWords, start } = messages.value;
  const isRead = useSignal(false);
  const isAsked = useSignal(false);
  const install = installation.install.value;
  const take = update.take.value;
  return (
    <section class="setting">
      <h2>{words.title}</h2>
      <p>
        {words.version(news.version)} {installation.ready.value ? words.offline : words.notOffline}
      </p>
      {news.releases.length > 0 && (
        <details onToggle={({ currentTarget }) => (isRead.value = currentTarget.open)}>
          <summary>{updateWords.news}</summary>
          {isRead.value && <ReleaseList releases={news.releases} />}
        </details>
      )}
      <details onToggle={({ currentTarget }) => (isAsked.value = currentTarget.open)}>
        <summary>{words.licences}</summary>
        <p>{words.madeWith}</p>
        {isAsked.value && <licenceList.Part />}
      </details>
      <div class="buttons">
        {take && (
          <button type="button" onClick={take}>
            {words.take(update.version.value)}
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
