import { useSignal } from '@preact/signals';
import { useId, useMemo } from 'preact/hooks';
import { fieldKey, type ProgramField, valueAt } from '../../program/index.js';
import { fieldLabel, figureText, messages, slotInSentence } from '../messages/index.js';
import { dutyName, servoName } from '../messages/names.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { SHAPES } from '../ui/shapes.js';
import { StepKey } from '../ui/step-key.js';
import { useQuery } from '../ui/use-query.js';
import { WasText } from '../ui/was-text.js';
import { FieldModel } from '../work/field-model.js';
import type { Session } from '../work/session.js';
import type { Bench } from './bench.js';
import type { Follow } from './follow.js';
import '../ui/value.css';
import './bench-trim.css';

interface BenchTrimProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
}

/**
 * The positions of the function where the servos stand, to type and with step keys. While the servos follow, each of
 * them moves its servo. A phone has room for one servo at a time.
 */
export function BenchTrim({ session, bench, follow }: BenchTrimProps) {
  const { bench: words } = messages.value;
  const working = session.editor.working.value;
  const uses = session.servoUses.named.value?.map(dutyName);
  const isPhone = useQuery(SHAPES.phone).value;
  const chosen = useSignal('0');
  const at = bench.stand.at.value;
  if (!working || at === null) return null;
  const { identity, positions } = working;
  const title = words.trim({ slot: slotInSentence(identity, at) });
  const servos = positions.map((_, servo) => String(servo));
  const one = isPhone && servos.length > 1 ? (servos.find((servo) => servo === chosen.value) ?? '0') : null;
  return (
    <section class="stack panel bench-trim" aria-label={title}>
      {one === null ? (
        <h2>{title}</h2>
      ) : (
        <SegmentChoice
          name="trim"
          {...{ title }}
          choices={servos}
          names={Object.fromEntries(positions.map((row, servo) => [servo, `${servoName(servo)} ${row[at]}`]))}
          chosen={one}
          onChoose={(servo) => {
            chosen.value = servo;
          }}
        />
      )}
      <div class="trim-servos">
        {(one === null ? servos : [one]).map(Number).map((servo) => (
          <Trim
            key={servo}
            {...{ session, follow }}
            field={{ kind: 'position', servo, slot: at }}
            name={one === null ? servoName(servo) : fieldLabel(identity, { kind: 'position', servo, slot: at })}
            use={uses?.[servo]}
          />
        ))}
      </div>
      {!follow.on.value && <p class="hint">{words.waits}</p>}
    </section>
  );
}

interface TrimProps extends Pick<BenchTrimProps, 'session' | 'follow'> {
  readonly field: ProgramField;
  readonly name: string;
  /** What the servo moves, as the pilot says. */
  readonly use?: string | undefined;
}

/** One value to type, between the keys for steps down and up, with what the timer held before. */
export function Trim({ session, follow, field, name, use = '' }: TrimProps) {
  const { editor, standing, trials } = session;
  const key = fieldKey(field);
  const model = useMemo(() => new FieldModel(editor, field), [editor, key]);
  const id = useId();
  const working = editor.working.value;
  if (!working) return null;
  const { text, was, isWrong, notes } = model.face.value;
  const label = fieldLabel(working.identity, field);
  // What was tried is in the timer already, so this is what it held before the servos followed.
  const before = trials.current.value && valueAt(trials.current.value.before, field);
  const isTried = before !== null && before !== valueAt(working, field);
  const isChanged = isTried || was !== null;
  const keys = (...steps: number[]) =>
    steps.map((by) => (
      <StepKey
        key={by}
        {...{ by, value: model }}
        isBehind={follow.isBehind}
        of={label}
        onStep={(isFirst) => {
          // A press is one step to undo, however long it lasts.
          if (isFirst) model.leave();
          model.step(by);
        }}
      />
    ));
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset cannot be laid out as a grid everywhere
    <div class="row trim" role="group" aria-label={`${label} ${use}`.trim()}>
      <p>
        {name} <bdi>{use}</bdi>{' '}
        {isChanged && (
          <span class="trim-was" id={id}>
            {isTried ? (
              messages.value.knowledge.marks.now({ value: figureText(working.identity, field, before) })
            ) : (
              <WasText standing={standing} value={was ?? ''} />
            )}
          </span>
        )}
      </p>
      <div class="trim-keys">
        {keys(-10, -1)}
        <span class={`value ${isWrong ? 'wrong' : isChanged ? 'changed' : ''}`}>
          <input
            type="text"
            inputMode="numeric"
            autocomplete="off"
            aria-label={label}
            aria-invalid={isWrong}
            aria-describedby={isChanged ? id : undefined}
            value={text}
            onFocus={({ currentTarget }) => currentTarget.select()}
            onInput={({ currentTarget }) => model.type(currentTarget.value)}
            onKeyDown={({ key: pressed, currentTarget }) => {
              if (pressed === 'Escape') model.escape();
              if (pressed !== 'Enter') return;
              model.leave();
              currentTarget.select();
            }}
            onBlur={() => model.leave()}
          />
        </span>
        {keys(1, 10)}
      </div>
      {isWrong && (
        <p class="bad-text" role="alert">
          {notes}
        </p>
      )}
    </div>
  );
}
