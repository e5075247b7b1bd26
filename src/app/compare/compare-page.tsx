import { useEffect, useMemo, useRef } from 'preact/hooks';
import { type Change, differences } from '../../program/index.js';
import { clockText, dateText, dayText, fieldInSentence, figureText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { BackHead } from '../ui/back-head.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { heldName, programName } from '../work/standing-text.js';
import { type ComparedPair, SCREEN } from './choice.js';
import { Compare, type Side } from './compare.js';
import { ProgramPair } from './program-pair.js';
import './compare-page.css';

export interface ComparePageProps {
  readonly session: Session;
  readonly pair: ComparedPair;
  /** Whether the servos follow edits: they would move with each value that is taken. */
  readonly following: boolean;
  readonly onBack: () => void;
}

/** Two programs side by side. Single values can be taken from one into the other, if that one is on the screen. */
export function ComparePage({ session, pair, following, onBack }: ComparePageProps) {
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
      <BackHead back={messages.value.views.names.library} to={onBack} titleId="compare-title" heading={heading}>
        {words.title}
      </BackHead>
      <div class="row gap-4 compare-choice">
        <Choice
          label={words.title}
          session={session}
          sides={compare.sides.value}
          chosen={first}
          onChoose={(key) => compare.chooseFirst(key)}
        />
        <Choice
          label={words.second}
          session={session}
          sides={compare.others.value}
          chosen={second}
          onChoose={(key) => compare.chooseSecond(key)}
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

function Pair({ session, compare, following, first, second }: PairProps) {
  const { compare: words } = moreMessages.value;
  const names = [sideName(session, first), sideName(session, second)] as const;
  const onScreen = first.key === SCREEN || second.key === SCREEN;
  const isSame = differences(first.program, second.program).length === 0;
  const setting = [first, second].find((side) => side.kind === 'setting');
  const canOpen = setting && !onScreen && session.opened.obstacle(setting.program) === null;
  // A value that the other program does not know cannot be taken.
  const other = first.key === SCREEN ? 'to' : 'from';
  const action = (change: Change) => {
    const value = change[other];
    if (value === null) return null;
    const { identity } = first.program;
    return (
      <button
        type="button"
        aria-label={words.takeOf({
          field: fieldInSentence(identity, change.field),
          value: figureText(identity, change.field, value),
        })}
        onClick={() => compare.take(change.field)}
      >
        {words.take}
      </button>
    );
  };
  return (
    <ProgramPair
      first={first.program}
      second={second.program}
      names={names}
      title={messages.value.timeline.title}
      actionOf={onScreen && !following ? action : undefined}
    >
      {onScreen && !isSame && <p class="hint">{following ? moreMessages.value.obstacles.following : words.takeHint}</p>}
      {canOpen && (
        <button type="button" onClick={() => void compare.open(setting)}>
          {words.openFirst({ name: setting.record.setting.name })}
        </button>
      )}
    </ProgramPair>
  );
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
      name: moreMessages.value.versions.until({ when: dateText(side.version.until) }),
    });
  const { program, savedAt } = side.backup;
  const memory = program.memory === null ? recovery.unknownMemory : memoryName(program.memory);
  const model = library.models.get(side.backup.model ?? null)?.model.name;
  const when = dayText(savedAt);
  return model === undefined ? words.backup({ memory, when }) : words.backupOf({ model, memory, when });
}
