import { useSignal } from '@preact/signals';
import { messages } from '../messages/index.js';
import { ValueTable } from '../write/value-table.js';
import { type Entry, entriesOf, type UnfinishedProps, type Way } from './unfinished-entries.js';
import '../write/unfinished-band.css';

/**
 * What is unfinished, in every view, until a reading or the pilot settles it: one band, the worst first, the rest
 * behind it.
 */
export function UnfinishedBand(props: UnfinishedProps) {
  const { more } = messages.value;
  const isOpen = useSignal(false);
  // What can be done about a write waits while the dialog of another one is open.
  const isWriting = props.write.current.value !== null;
  const jobs = props.session.unfinished.value.filter(
    ({ kind }) => !isWriting || (kind !== 'offer' && kind !== 'tried'),
  );
  if (jobs.length === 0) return null;
  const shown = isOpen.value ? jobs : jobs.slice(0, 1);
  return (
    <div class="unfinished" aria-live="assertive">
      {shown.flatMap((job) =>
        entriesOf(props, job).map((entry) => <Unfinished key={`${job.key} ${entry.name}`} entry={entry} />),
      )}
      {jobs.length > 1 && (
        <p class="unfinished-more">
          <button
            type="button"
            class="quiet"
            aria-expanded={isOpen.value}
            onClick={() => (isOpen.value = !isOpen.value)}
          >
            {more({ count: jobs.length - 1 })}
          </button>
        </p>
      )}
    </div>
  );
}

/** What is unfinished, and what can be done about it. */
function Unfinished({ entry }: { readonly entry: Entry }) {
  const { name, isGrave, title, said, table, hint, ways } = entry;
  const { cancel, recovery } = messages.value;
  const asked = useSignal<Way['sure'] | null>(null);
  const sure = asked.value;
  return (
    <section class={`row between ${isGrave ? 'uncertain' : 'recovery'}`} aria-label={name}>
      <p key={title}>
        <strong>{title}</strong> {said && <span>{said}</span>}
      </p>
      {table && (
        <details>
          <summary>{recovery.compare}</summary>
          <ValueTable {...table} lastCounts />
        </details>
      )}
      {hint && <p class="hint">{hint}</p>}
      {sure && <p>{sure.said}</p>}
      <div class="buttons">
        {sure ? (
          <>
            <button type="button" onClick={() => (asked.value = null)}>
              {cancel}
            </button>
            <button type="button" onClick={sure.run}>
              {sure.label}
            </button>
          </>
        ) : (
          ways.map(({ label, look, disabled = false, run, sure }) => (
            <button
              type="button"
              key={label}
              class={look}
              disabled={disabled}
              onClick={() => {
                asked.value = sure ?? null;
                run?.();
              }}
            >
              {label}
            </button>
          ))
        )}
      </div>
    </section>
  );
}
