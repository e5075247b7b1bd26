import { computed, type ReadonlySignal } from '@preact/signals';
import type { UnfinishedRoundTrip, UnfinishedWrite } from '../storage/index.js';
import type { JobRunner } from '../timer/job-runner.js';
import type { Knowledge } from '../timer/knowledge.js';
import type { NextFlight, NextFlightWord } from '../timer/next-flight.js';
import type { OpenTrial, Trials } from '../timer/trials.js';
import type { InterruptedJobs, Offer } from './interrupted-jobs.js';

/** Something that was begun with a timer and has no end yet. `key` tells it from the others. */
export type OpenJob = { readonly key: string } & (
  | {
      /** It is not known what a memory holds. */
      readonly kind: 'uncertain';
      readonly record: UnfinishedWrite;
      /** Set when the connected timer was read, and holds something that the write does not explain. */
      readonly offer: Extract<Offer, { kind: 'write' }> | null;
    }
  /** Another memory than the one that is meant may fly next, by a record; the timer was not asked since. */
  | { readonly kind: 'left'; readonly record: UnfinishedRoundTrip }
  /** The same, by what the connected timer says, or does not say. */
  | { readonly kind: 'flight'; readonly word: NextFlightWord }
  /** What the connected timer was found to hold, and what can be done about it. */
  | { readonly kind: 'offer'; readonly offer: Offer }
  /** Positions that were tried in a memory. */
  | { readonly kind: 'tried'; readonly trial: OpenTrial }
);

interface Parts {
  readonly knowledge: Pick<Knowledge, 'uncertain'>;
  readonly recovery: Pick<InterruptedJobs, 'offer' | 'left'>;
  readonly nextFlight: Pick<NextFlight, 'word'>;
  readonly runner: Pick<JobRunner, 'busy'>;
  readonly trials: Pick<Trials, 'open'>;
}

/**
 * Everything that is unfinished, the worst first: what a memory holds, which memory flies, what was half written, what
 * was tried. Also of timers that are not connected, from the first picture on, until a reading or the pilot settles it.
 */
export function unfinishedWork(parts: Parts): ReadonlySignal<readonly OpenJob[]> {
  const { knowledge, recovery, nextFlight, runner, trials } = parts;
  return computed(() => {
    const offer = recovery.offer.value;
    const uncertain = knowledge.uncertain.value;
    const isUncertain = offer !== null && uncertain.some(({ key }) => key === offer.record.key);
    const contents = uncertain.map((record): OpenJob => {
      const isOffered = offer?.kind === 'write' && offer.record.key === record.key;
      return { kind: 'uncertain', key: record.key, record, offer: isOffered ? offer : null };
    });
    const offers: OpenJob[] = offer && !isUncertain ? [{ kind: 'offer', key: `offer ${offer.record.key}`, offer }] : [];
    const left = recovery.left.value
      .filter(({ key }) => !(offer?.kind === 'memories' && offer.record.key === key))
      .map((record): OpenJob => ({ kind: 'left', key: record.key, record }));
    const word = nextFlight.word.value;
    // During a job over memories there is nothing to say yet. The record of the job says more.
    const isSaid = word === null || runner.busy.value || left.length > 0 || offer?.kind === 'memories';
    const flight: OpenJob[] = isSaid ? [] : [{ kind: 'flight', key: 'flight', word }];
    const tried = trials.open.value.map((trial): OpenJob => ({ kind: 'tried', key: `tried ${trial.key}`, trial }));
    const isOfFlight = offer?.kind === 'memories';
    return [...contents, ...(isOfFlight ? offers : []), ...left, ...flight, ...(isOfFlight ? [] : offers), ...tried];
  });
}
