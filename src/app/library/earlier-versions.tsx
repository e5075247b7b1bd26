import { differences, type SettingVersion, type TimerProgram } from '../../program/index.js';
import { isOfOneShape } from '../editing/shape.js';
import { changeText, dateText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { hasSameValues } from '../records/versions.js';
import type { SettingRecord } from '../storage/index.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { Session } from '../work/session.js';

interface EarlierVersionsProps {
  readonly session: Session;
  readonly record: SettingRecord;
  /** Compares a version with what the setting holds now. */
  readonly onCompare: (version: SettingVersion) => void;
}

/** What a setting held before each save over it, the latest first, and what that save changed. */
export function EarlierVersions({ session, record, onCompare }: EarlierVersionsProps) {
  const { setting, versions = [] } = record;
  // The oldest goes when one more is kept.
  const box = useHandedFocus('summary');
  if (versions.length === 0) return null;
  return (
    <div {...box}>
      <details key={record.key}>
        <summary>{moreMessages.value.versions.title}</summary>
        <ul class="panel ruled">
          {versions.map((version, at) => (
            <Row
              key={version.until}
              version={version}
              next={versions[at - 1]?.program ?? setting.program}
              now={setting.program}
              onCompare={() => onCompare(version)}
              onGoBack={() => void session.opened.goBack(setting, version)}
            />
          ))}
        </ul>
      </details>
    </div>
  );
}

interface RowProps {
  readonly version: SettingVersion;
  /** What the setting held after it. */
  readonly next: TimerProgram;
  /** What the setting holds now. */
  readonly now: TimerProgram;
  readonly onCompare: () => void;
  readonly onGoBack: () => void;
}

function Row({ version: { program, until }, next, now, onCompare, onGoBack }: RowProps) {
  const { of } = messages.value;
  const { versions: words, compare } = moreMessages.value;
  const name = words.until({ when: dateText(until) });
  const isNow = hasSameValues(program, now);
  const { open } = compare;
  return (
    <li class="row kept-row">
      <p>
        <strong>{name}</strong> <span class="hint">{changedTo(program, next)}</span>
      </p>
      {isNow ? (
        <p class="hint">{words.same}</p>
      ) : (
        <div class="buttons">
          {isOfOneShape(program.identity, now.identity) && (
            <button type="button" class="quiet" aria-label={of({ button: open, name })} onClick={onCompare}>
              {open}
            </button>
          )}
          <button type="button" aria-label={of({ button: words.goBack, name })} onClick={onGoBack}>
            {words.goBack}
          </button>
        </div>
      )}
    </li>
  );
}

/** What a save changed: “then DT: 3:00 min → 3:30 min and 2 more”. */
function changedTo(from: TimerProgram, to: TimerProgram): string {
  const { versions: words } = moreMessages.value;
  if (!isOfOneShape(from.identity, to.identity)) return words.otherLayout;
  const [first, ...more] = differences(from, to);
  return first ? words.changed({ change: changeText(from.identity, first), more: more.length }) : '';
}
