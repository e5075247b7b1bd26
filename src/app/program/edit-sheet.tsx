import type { ReadonlySignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import type { Identity } from '../../protocol/index.js';
import { onBackInHistory, onBackKey } from '../browser/back-key.js';
import { eitherTexts, messages } from '../messages/index.js';
import type { Standing } from '../timer/standing.js';
import { Icon } from '../ui/icon.js';
import { StepKey } from '../ui/step-key.js';
import { WasText } from '../ui/was-text.js';
import type { HeldField } from './hand.js';
import { type Goal, goalsFrom } from './sheet-moves.js';
import { useSheetPlace } from './sheet-place.js';
import { eraseLast, typeInto } from './sheet-typing.js';
import { cellOf } from './table-cells.js';
import type { TableModel } from './table-model.js';
import './edit-sheet.css';

interface EditSheetProps {
  readonly table: TableModel;
  readonly identity: Identity;
  readonly standing: ReadonlySignal<Standing>;
  /** Whether an earlier step is still on its way to the timer. */
  readonly isBehind: ReadonlySignal<boolean>;
}

/**
 * Replaces the screen keyboard for a field that a finger has tapped: steps, digits, the old value, and keys to other
 * fields. The focus stays in the field, which scrolls into sight.
 */
export function EditSheet(props: EditSheetProps) {
  const held = props.table.hand.field.value;
  return held && <Sheet {...props} held={held} />;
}

function Sheet({ table, identity, standing, isBehind, held }: EditSheetProps & { readonly held: HeldField }) {
  const { edits, done } = messages.value;
  const { sheet: words } = edits;
  const { input, label, value } = held;
  const element = useRef<HTMLDivElement>(null);
  /** Whether the next digit begins a new value. After a step, the last digit is not what was wrong. */
  const isWhole = useRef(false);
  useSheetPlace(element, input);
  useEffect(() => {
    const close = (): void => input.blur();
    const ends = [onBackKey(close), onBackInHistory(close)];
    return () => {
      for (const end of ends) end();
    };
  }, [input]);
  useLayoutEffect(() => {
    isWhole.current = false;
  }, [input]);
  const { text, unit, was, notes, either, canPutBack } = value.face.value;
  const isTime = value.kind !== 'steps';
  const goals = goalsFrom(identity, input);
  const act = (work: () => void): void => {
    isWhole.current = true;
    work();
  };
  const type = (digit: string): void => {
    if (isWhole.current) input.select();
    isWhole.current = false;
    typeInto(input, digit);
  };
  const go = ({ input: to }: Goal): void => {
    if (value.finish()) to.focus();
  };
  const stepKey = (by: number): ComponentChildren => (
    <StepKey {...{ value, by, isBehind }} onStep={() => act(() => value.step(by))} />
  );
  const digits = (...texts: string[]): ComponentChildren =>
    texts.map((text) => (
      <button type="button" key={text} tabIndex={-1} onClick={() => type(text)}>
        {text}
      </button>
    ));
  const goTo = (goal: Goal | null, text: (name: string) => string): ComponentChildren =>
    goal ? (
      <button
        type="button"
        class="go"
        tabIndex={-1}
        aria-label={words.goTo({ name: text(goal.name) })}
        onClick={() => go(goal)}
      >
        {text(goal.name)}
      </button>
    ) : (
      <span />
    );
  return (
    <section
      ref={element}
      class="stack low-sheet edit-sheet"
      popover="manual"
      aria-label={words.title({ field: label })}
      // The focus stays in the field.
      onPointerDown={(event) => event.preventDefault()}
      onMouseDown={(event) => event.preventDefault()}
    >
      <div class="sheet-head">
        <p>
          <strong>{label}</strong>{' '}
          {was !== null && (
            <span class="sheet-was">
              <WasText standing={standing} value={was} />
            </span>
          )}
        </p>
        {cellOf(input) && (
          <button
            type="button"
            class="quiet"
            tabIndex={-1}
            aria-label={words.selectRange}
            onClick={() => {
              table.selection.pick();
              input.blur();
            }}
          >
            <Icon
              path="M4 8V4H8M16 4H20V8M20 16V20H16M8 20H4V16M12 4H12M12 20H12M4 12H4M20 12H20"
              width={24}
              height={24}
            />
          </button>
        )}
        {canPutBack && (
          <button type="button" tabIndex={-1} onClick={() => act(() => value.putBack())}>
            {words.putBack}
          </button>
        )}
      </div>
      {notes && <p class="notes bad-text">{notes}</p>}
      {either ? (
        <fieldset class="sheet-question">
          <legend class="visually-hidden">{messages.value.times.meaning({ field: label })}</legend>
          {eitherTexts(either).map((text, at) => (
            <button
              type="button"
              key={text}
              tabIndex={-1}
              onClick={() => act(() => value.answer(either[at] as number))}
            >
              {text}
            </button>
          ))}
        </fieldset>
      ) : (
        <div class="sheet-steps">
          {stepKey(-10)}
          {stepKey(-1)}
          <output>
            {text}
            {unit && <small> {messages.value.times.units[unit]}</small>}
          </output>
          {stepKey(1)}
          {stepKey(10)}
        </div>
      )}
      <div class="sheet-pad">
        {digits('7', '8', '9')}
        {isTime ? digits(':') : goTo(goals.above, (name) => `↑ ${name}`)}
        {digits('4', '5', '6')}
        {isTime ? digits('.') : goTo(goals.below, (name) => `↓ ${name}`)}
        {digits('1', '2', '3')}
        <button type="button" tabIndex={-1} aria-label={words.erase} onClick={() => eraseLast(input)}>
          <Icon path="M8 3H21V17H8L2 10ZM11 7L17 13M17 7L11 13" width={24} />
        </button>
        {goTo(goals.before, (name) => `‹ ${name}`)}
        {digits('0')}
        {goTo(goals.after, (name) => `${name} ›`)}
        <button type="button" class="primary" tabIndex={-1} onClick={() => (either || value.finish()) && input.blur()}>
          {done}
        </button>
      </div>
    </section>
  );
}
