import * as v from 'valibot';
import { answerOf, tried } from './services.js';

/** What is new in one release, for a pilot, as plain text: each change below what it is about. */
export interface Release {
  readonly version: string;
  readonly changes: readonly { readonly title: string; readonly items: readonly string[] }[];
}

/** What a version says of itself and of those before it, the newest first. */
export interface News {
  readonly version: string;
  readonly releases: readonly Release[];
}

// What waits may be a version of any time: what is not understood is passed over.
const text = v.pipe(v.string(), v.maxLength(1000));
const texts = v.pipe(v.array(text), v.maxLength(200));
const changes = v.pipe(v.array(v.object({ title: text, items: texts })), v.maxLength(50));
const releases = v.pipe(v.array(v.object({ version: text, changes })), v.maxLength(20));
const newsSchema = v.object({ version: text, releases });

/**
 * What is new in a version that waits, by its own word: its worker has it with it, so there need be no network.
 * @returns null when it does not say: a worker of another make.
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

/** The releases that whoever has `version` does not know yet; at least the newest. */
export function newTo(version: string, { releases }: News): readonly Release[] {
  const known = releases.findIndex((release) => release.version === version);
  return releases.slice(0, known < 0 ? undefined : Math.max(1, known));
}
