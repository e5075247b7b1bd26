import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { type Change, differences } from '../../program/index.js';
import { clockText, dateText, dayText, fieldInSentence, figureText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { Timeline } from '../timeline/timeline.js';
import { TimelineModel } from '../timeline/view-model.js';
import { BackHead } from '../ui/back-head.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { heldName, programName } from '../work/standing-text.js';
import { LONG_LIST } from '../write/difference.js';
import { ValueTable } from '../write/value-table.js';
import { type ComparedPair, SCREEN } from './choice.js';
import { Compare, type Side } from './compare.js';
import './compare-page.css';

export interface ComparePageProps {
  readonly session: Session;
  readonly pair: ComparedPair;
  /** Whether the servos follow edits: they would move with each value that is taken. */
  readonly following: boolean;
}

/** Two programs side by side. Single values can be taken from one into the other, if that one is on the screen. */
export function ComparePage({ session, pair, following }: ComparePageProps) {
  const compare = useMemo(() => new Compare(session, pair), [session, pair]);
  const { compare: words } = moreMessages.value;
  const heading = useRef<HTMLHeadingElement>(null);
  useEffect(() => {
    heading.current?.focus({ preventScroll: true });
    void session.library.load();
  }, [session]);
  const first = compare.first.value;
  const second = compare.second.value;
  return (
    <section class="stack gap-3 compare-page" aria-labelledby="compare-title">
      <BackHead back={messages.value.views.names.library} to="#library" titleId="compare-title" heading={heading}>
        {words.title}
      </BackHead>
      <div class="row gap-4 compare-choice">
        <Choice
          label={words.title}
          session={session}
          sides={compare.sides.value}
          chosen={first}
          onChoose={(key) => pair.show(key, pair.second.peek())}
        />
        <Choice
          label={words.second}
          session={session}
          sides={compare.others.value}
          chosen={second}
          onChoose={(key) => pair.show(first?.key ?? null, key)}
        />
      </div>
      {first && second ? (
        <Pair {...{ session, compare, following, first, second }} />
      ) : (
        <p class="hint">{words.nothing}</p>
      )}
    </section>
  );
}

interface PairProps extends Pick<ComparePageProps, 'session' | 'following'> {
  readonly compare: Compare;
  readonly first: Side;
  readonly second: Side;
}

/** What differs, in figures and over time. */
function Pair({ session, compare, following, first, second }: PairProps) {
  const { compare: words, overview, obstacles } = moreMessages.value;
  const { write } = messages.value;
  const names = [sideName(session, first), sideName(session, second)] as const;
  const { identity } = first.program;
  const onScreen = first.key === SCREEN || second.key === SCREEN;
  const changes = differences(first.program, second.program);
  const servo = firstServo(changes);
  const model = useMemo(() => new TimelineModel(), []);
  // A small difference shows only in the tall lane. The pilot may then choose another one.
  useLayoutEffect(() => model.bringToFront(servo), [model, servo]);
  // A value that the other program does not know cannot be taken.
  const other = first.key === SCREEN ? 'to' : 'from';
  const action = (change: Change) => {
    const value = change[other];
    if (value === null) return null;
    return (
      <button
        type="button"
        class="chip"
        aria-label={words.takeOf({
          field: fieldInSentence(identity, change.field),
          value: figureText(identity, change.field, value),
        })}
        onClick={() => compare.take(change.field, value)}
      >
        {words.take}
      </button>
    );
  };
  // With the buttons, the values stand one below the other, however many there are.
  const canTake = onScreen && !following;
  const isGrid = changes.length > LONG_LIST && !canTake;
  return (
    <div class="stack gap-4 compare-pair">
      <div class="stack gap-3 panel compare-values">
        <p role="status">
          <strong>{changes.length === 0 ? overview.same : overview.differs({ count: changes.length })}</strong>
        </p>
        {onScreen && changes.length > 0 && <p class="hint">{following ? obstacles.following : words.takeHint}</p>}
        {isGrid && (
          <ProgramGrid
            program={first.program}
            other={second.program}
            caption={write.sideBySide({ names: names.join(', ') })}
            names={names}
          />
        )}
        {!isGrid && changes.length > 0 && (
          <ValueTable
            identity={identity}
            names={names}
            rows={changes.map((change) => ({
              field: change.field,
              values: [change.from, change.to],
              note: canTake && action(change),
            }))}
          />
        )}
      </div>
      <Timeline program={first.program} overlay={{ program: second.program, name: names[1] }} model={model} />
    </div>
  );
}

/** The first servo whose positions differ; the first of all if none do. */
function firstServo(changes: readonly Change[]): number {
  const servos = changes.flatMap(({ field }) => (field.kind === 'position' ? [field.servo] : []));
  return servos.length === 0 ? 0 : Math.min(...servos);
}

interface ChoiceProps {
  readonly label: string;
  readonly session: Session;
  readonly sides: readonly Side[];
  readonly chosen: Side | null;
  readonly onChoose: (key: string) => void;
}

function Choice({ label, session, sides, chosen, onChoose }: ChoiceProps) {
  const { compare: words } = moreMessages.value;
  const { backups } = messages.value;
  const groups = [
    { name: words.groups.now, of: sides.filter(({ kind }) => kind === 'screen' || kind === 'timer') },
    { name: words.groups.settings, of: sides.filter(({ kind }) => kind === 'setting') },
    { name: moreMessages.value.versions.title, of: sides.filter(({ kind }) => kind === 'version') },
    { name: backups.title, of: sides.filter(({ kind }) => kind === 'backup') },
  ];
  return (
    <label class="field">
      <span>{label}</span>
      <select
        value={chosen?.key ?? ''}
        disabled={sides.length === 0}
        onChange={(event) => onChoose(event.currentTarget.value)}
      >
        {groups
          .filter(({ of }) => of.length > 0)
          .map(({ name, of }) => (
            <optgroup key={name} label={name}>
              {of.map((side) => (
                <option key={side.key} value={side.key}>
                  {sideName(session, side)}
                </option>
              ))}
            </optgroup>
          ))}
      </select>
    </label>
  );
}

/** The name of a program on this page. */
export function sideName(session: Session, side: Side): string {
  const { compare: words } = moreMessages.value;
  const { recovery } = messages.value;
  const { library } = session;
  if (side.kind === 'screen') {
    const name = programName(session);
    return name === '' ? words.screen : words.setting({ model: words.screen, name });
  }
  if (side.kind === 'timer')
    return heldName(words.timer({ memory: memoryText(session, side.held.memory) }), side.held, clockText);
  if (side.kind === 'setting') {
    const { setting } = side.record;
    const model = library.models.get(setting.model)?.model.name;
    return model === undefined ? setting.name : words.setting({ model, name: setting.name });
  }
  if (side.kind === 'version')
    return words.setting({
      model: side.record.setting.name,
      name: moreMessages.value.versions.until({ when: dateText(side.until) }),
    });
  const { program, savedAt } = side.backup;
  const memory = program.memory === null ? recovery.unknownMemory : memoryName(program.memory);
  const model = library.models.get(side.backup.model ?? null)?.model.name;
  const when = dayText(savedAt);
  return model === undefined ? words.backup({ memory, when }) : words.backupOf({ model, memory, when });
}
