import * as v from 'valibot';
import { answerOf, tried } from './services.js';

/** What is new in one release, for a pilot, as plain text: changes under the heading that they belong to. */
export interface Release {
  readonly version: string;
  readonly changes: readonly { readonly title: string; readonly items: readonly string[] }[];
}

/** What a version says about itself and the versions before it, newest first. */
export interface News {
  readonly version: string;
  readonly releases: readonly Release[];
}

// The waiting version may be of any age: what this one does not understand is skipped.
const text = v.pipe(v.string(), v.maxLength(1000));
const texts = v.pipe(v.array(text), v.maxLength(200));
const changes = v.pipe(v.array(v.object({ title: text, items: texts })), v.maxLength(50));
const releases = v.pipe(v.array(v.object({ version: text, changes })), v.maxLength(20));
const newsSchema = v.object({ version: text, releases });

/**
 * What is new in a waiting version, in its own words. Its worker carries them, so no network is needed.
 * @returns null when it does not say, as another kind of worker.
 */
export async function newsOfWaiting(worker: Pick<ServiceWorker, 'postMessage'>): Promise<News | null> {
  const channel = tried(() => new MessageChannel());
  if (!channel) return null;
  const answer = new Promise<unknown>((resolve) => {
    channel.port1.onmessage = ({ data }: MessageEvent<unknown>) => resolve(data);
  });
  const said = await answerOf(() => {
    worker.postMessage({ type: 'NEWS' }, [channel.port2]);
    return answer;
  }).catch(() => null);
  channel.port1.close();
  return v.is(newsSchema, said) ? said : null;
}

/** The releases that a pilot with `version` does not know yet; at least the newest. */
export function newTo(version: string, { releases }: News): readonly Release[] {
  const known = releases.findIndex((release) => release.version === version);
  return releases.slice(0, known < 0 ? undefined : Math.max(1, known));
}
