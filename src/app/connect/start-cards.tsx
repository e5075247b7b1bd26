import { useSignal } from '@preact/signals';
import { dotted } from '../messages/dotted.js';
import { clockText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { memoryName, timerName } from '../messages/names.js';
import type { Backups } from '../records/backups.js';
import type { Draft } from '../storage/index.js';
import { NewProgramDialog } from '../ui/new-program-dialog.js';
import type { Session } from '../work/session.js';
import { SIMULATED_CLASSES } from '../work/timer-access.js';
import './start-cards.css';

/** How many models are named here. The library has the others. */
const NAMED = 4;

/** What this device keeps: the pilot's models, programs that are in no timer, and backups. */
export function KeptCard({ session }: { readonly session: Session }) {
  const { newProgram, start } = messages.value;
  const { backups, drafts, library } = session;
  const making = useSignal(false);
  const { models: words } = start;
  const models = library.models.list.value.filter(({ model }) => !model.archived);
  const counts = new Map<string | null, number>();
  for (const { setting } of library.settings.list.value) {
    counts.set(setting.model, (counts.get(setting.model) ?? 0) + 1);
  }
  const unfinished = drafts.edited.value;
  return (
    <section class="stack panel start-card" aria-labelledby="models-title">
      <h2 id="models-title">{words.title}</h2>
      {models.length === 0 && <p>{words.none}</p>}
      {models.length > 0 && (
        <ul class="ruled">
          {models.slice(0, NAMED).map(({ key, model }) => (
            <li key={key}>
              <a class="kept" href={`#library/${key}`}>
                <strong>{model.name}</strong> <span>{words.programs({ count: counts.get(key) ?? 0 })}</span>
              </a>
            </li>
          ))}
        </ul>
      )}
      {unfinished.length > 0 && (
        <>
          <h3 id="unfinished-title">{start.programs.title}</h3>
          <ul class="ruled" aria-labelledby="unfinished-title">
            {unfinished.map((draft) => (
              <KeptProgram key={draft.key} session={session} draft={draft} />
            ))}
          </ul>
        </>
      )}
      <KeptBackups backups={backups} />
      <div class="buttons">
        <button type="button" onClick={() => (making.value = true)}>
          {newProgram.title}
        </button>
        <a class="alone" href="#library">
          {words.library}
        </a>
      </div>
      <NewProgramDialog
        open={making.value}
        onMake={(program) => session.onScreen.make(program)}
        onClose={() => (making.value = false)}
      />
    </section>
  );
}

function KeptProgram({ session, draft }: { readonly session: Session; readonly draft: Draft }) {
  const { cancel, delete: remove, of, open, start } = messages.value;
  const words = start.programs;
  const asked = useSignal(false);
  const { working, madeAt, savedAt } = draft;
  const setting = draft.of && session.library.settings.get(draft.of.id)?.setting.name;
  const what = setting === undefined ? nameOf(draft) : words.changesOf({ timer: setting });
  const when = clockText(draft.of ? savedAt : (madeAt ?? savedAt));
  const [dt] = keyFigures(working);
  if (asked.value) {
    return (
      <li class="row">
        <strong class="kept" role="status">
          {words.sure}
        </strong>
        <button type="button" onClick={() => void session.drafts.remove(draft)}>
          {remove}
        </button>
        <button type="button" onClick={() => (asked.value = false)}>
          {cancel}
        </button>
      </li>
    );
  }
  return (
    <li class="row">
      <button
        type="button"
        class="quiet kept"
        disabled={session.engaged.value}
        onClick={() => session.onScreen.showKept(draft)}
      >
        <span class="visually-hidden">{open}</span> <strong>{what}</strong> <span>{when}</span>{' '}
        <span>{dt && `${dt.label} ${dt.text}`}</span>
      </button>
      <button
        type="button"
        class="quiet"
        aria-label={of({ button: remove, name: `${what}, ${when}` })}
        onClick={() => (asked.value = true)}
      >
        {remove}
      </button>
    </li>
  );
}

/** “F1Q, new”, “F1Q, M2, changes”. */
function nameOf({ working: { identity, memory }, madeAt }: Draft): string {
  const { start } = messages.value;
  const timer = timerName(identity);
  if (madeAt !== undefined) return start.programs.made({ timer });
  return start.programs.changesOf({ timer: memory === null ? timer : `${timer}, ${memoryName(memory)}` });
}

/** A simulated timer on which a pilot can try everything. */
export function Simulated({ session }: { readonly session: Session }) {
  const { start, classNames } = messages.value;
  return (
    <section class="stack panel start-card" aria-labelledby="simulated-title" data-lead="simulated">
      <h2 id="simulated-title">{start.simulatedTitle}</h2>
      <p>{start.simulatedLead}</p>
      <div class="buttons">
        {SIMULATED_CLASSES.map((timerClass) => {
          const name = classNames[timerClass] ?? timerClass;
          return (
            <button
              type="button"
              key={timerClass}
              aria-label={start.simulated({ name })}
              disabled={session.engaged.value}
              onClick={() => void session.timer.trySimulated(timerClass)}
            >
              {name}
            </button>
          );
        })}
      </div>
    </section>
  );
}

/** What timers held before they were written. */
function KeptBackups({ backups }: { readonly backups: Backups }) {
  const { start } = messages.value;
  const list = backups.list.value;
  const [last] = list;
  if (!last) return null;
  const { identity, memory } = last.program;
  const what = dotted([timerName(identity), memory === null ? null : memoryName(memory)]);
  return (
    <p>
      <a class="alone" href="#memories">
        {start.backups({ count: list.length, last: `${clockText(last.savedAt)}, ${what}` })}
      </a>
    </p>
  );
}
