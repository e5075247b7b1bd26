import { askForFiles } from '../browser/ask-for-file.js';
import { saveFile } from '../browser/save-file.js';
import { whole } from '../messages/dotted.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { Choice } from '../ui/choice.js';
import { CopyButton } from '../ui/copy-button.js';
import type { Session } from '../work/session.js';
import type { LineFilter, LineView } from './line-view.js';
import { captureText } from './recording.js';
import { captureNotes, reportText } from './report.js';
import './line-tools.css';

const FILTERS: readonly LineFilter[] = ['all', 'out', 'in', 'damaged'];

/** The tools of the log: pause, clear, copy, save, load, filter. */
export function LineTools({ session, view }: { readonly session: Session; readonly view: LineView }) {
  const { line } = moreMessages.value;
  const used = !view.unused.value;
  const live = used && view.recording.value === null;
  return (
    <>
      <div class="row">
        {live && (
          <>
            <button type="button" onClick={() => (view.paused.value ? view.goOn() : view.pause())}>
              {view.paused.value ? line.goOn : messages.value.pause}
            </button>
            <button type="button" onClick={() => view.clear()}>
              {line.clear}
            </button>
          </>
        )}
        {used && (
          <CopyButton
            label={messages.value.copy}
            text={() => captureText(view.found.value, captureNotes(view.found.value))}
          />
        )}
        {live && (
          <button type="button" disabled={view.all.value.length === 0} onClick={() => save(view)}>
            {messages.value.save}
          </button>
        )}
        <button
          type="button"
          onClick={() => askForFiles('.txt,text/plain', ([file]) => void (file && view.load(file)))}
        >
          {line.load}
        </button>
        <CopyButton label={line.copyReport} text={() => reportText(session)} />
        <p role="status">{live && view.paused.value && <strong>{line.came({ number: view.came.value })}</strong>}</p>
      </div>
      {used && <LineChoice view={view} />}
    </>
  );
}

function LineChoice({ view }: { readonly view: LineView }) {
  const { label } = messages.value;
  const { line } = moreMessages.value;
  return (
    <div class="row gap-4 line-choice">
      <Choice
        label={line.filter}
        choices={FILTERS}
        nameOf={(filter) => line[filter]}
        chosen={view.filter.value}
        onChoose={(filter) => view.setFilter(filter)}
      />
      <label class="field search">
        <span>{label.search}</span>
        <input
          type="search"
          autocomplete="off"
          spellcheck={false}
          placeholder={line.searchHint}
          value={view.search.value}
          onInput={(event) => view.setSearch(event.currentTarget.value)}
        />
      </label>
      {view.recording.value === null && <Counts view={view} />}
    </div>
  );
}

function Counts({ view }: { readonly view: LineView }) {
  const { out, in: incoming, damaged, errors } = view.counts.value;
  const { counts: words } = moreMessages.value.line;
  const counts = [
    words.out({ count: out }),
    words.in({ count: incoming }),
    words.damaged({ count: damaged }),
    words.errors({ count: errors }),
  ];
  return <p class="hint">{counts.map(whole).join(', ')}</p>;
}

function save(view: LineView): void {
  const { line } = moreMessages.value;
  const records = view.toSave();
  const identity = records.at(-1)?.layout.identity;
  const kind = identity ? `${identity.timerClass}${identity.firmware}` : line.unidentified;
  // The letter of a class may be any printable character.
  saveFile(`sidus-line-${kind.replaceAll(/[^a-z0-9]/gi, '_')}.txt`, captureText(records, captureNotes(records)));
}
