import { type Signal, useSignal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { energy as words } from '../messages/en-guide.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { allowanceFor, ENERGY_RULES, type EnergyEvent, energyOf, figureIn } from './energy.js';
import './energy-page.css';

/** A figure to type, and its range. */
interface Asked {
  readonly label: string;
  readonly unit: string;
  readonly least: number;
  readonly most: number;
}

const WEIGHT: Asked = { label: words.weight, unit: words.grams, least: 10, most: 5000 };
const POWER: Asked = { label: words.power, unit: words.watts, least: 1, most: 5000 };
const VOLTAGE: Asked = { label: words.voltage, unit: words.volts, least: 1, most: 60 };
const CURRENT: Asked = { label: words.current, unit: words.amperes, least: 0.1, most: 200 };
type Way = keyof typeof words.ways;

/**
 * How long the motor may run by the rules of F1Q. @param motorStop of the program on the screen, in hundredths of a
 * second.
 */
export function EnergyPage({ motorStop }: { readonly motorStop: number | null }) {
  const event = useSignal<EnergyEvent>('rounds');
  const way = useSignal<Way>('watts');
  const weight = useSignal('');
  const watts = useSignal('');
  const volts = useSignal('');
  const amperes = useSignal('');
  const typed = (text: Signal<string>, { least, most }: Asked): number | null => figureIn(text.value, least, most);
  const product = (typed(volts, VOLTAGE) ?? 0) * (typed(amperes, CURRENT) ?? 0);
  const power = way.value === 'watts' ? (typed(watts, POWER) ?? 0) : product;
  const grams = typed(weight, WEIGHT);
  const rule = ENERGY_RULES[event.value];
  return (
    <div class="energy-page">
      <p>{words.lead}</p>
      <SegmentChoice
        name="energy-event"
        title={words.event}
        choices={['rounds', 'flyOff']}
        names={words.events}
        chosen={event.value}
        onChoose={(chosen) => (event.value = chosen)}
      />
      <SegmentChoice
        name="energy-way"
        title={words.by}
        choices={['watts', 'product']}
        names={words.ways}
        chosen={way.value}
        onChoose={(chosen) => (way.value = chosen)}
      />
      <div class="energy-fields">
        <Figure asked={WEIGHT} text={weight} />
        {way.value === 'watts' ? (
          <Figure asked={POWER} text={watts} />
        ) : (
          <>
            <Figure asked={VOLTAGE} text={volts} />
            <Figure asked={CURRENT} text={amperes} />
          </>
        )}
      </div>
      <p class="hint">{words.measured}</p>
      <div class="energy-result" role="status">
        {grams !== null && power > 0 ? (
          <Result event={event.value} grams={grams} power={power} motorStop={motorStop} />
        ) : (
          <p>{words.missing}</p>
        )}
      </div>
      <p>
        {words.rule(rule.perGram, rule.most, rule.longest)} <strong>{words.told(ENERGY_RULES.toldIn)}</strong>{' '}
        {event.value === 'flyOff' && words.flyOffTold}
      </p>
      <p class="hint">{words.limiter}</p>
    </div>
  );
}

function Figure({ asked, text }: { readonly asked: Asked; readonly text: Signal<string> }) {
  const { label, unit, least, most } = asked;
  const id = useId();
  const isWrong = text.value.trim() !== '' && figureIn(text.value, least, most) === null;
  return (
    <div class="energy-field">
      <label for={id}>{label}</label>
      <span>
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          maxLength={10}
          value={text.value}
          aria-invalid={isWrong}
          aria-describedby={isWrong ? `${id}-wrong` : undefined}
          onInput={({ currentTarget }) => (text.value = currentTarget.value)}
        />{' '}
        {unit}
      </span>
      {isWrong && (
        <span id={`${id}-wrong`} class="bad-text" role="alert">
          {words.wrong(`${least} ${unit}`, `${most} ${unit}`)}
        </span>
      )}
    </div>
  );
}

interface ResultProps {
  readonly event: EnergyEvent;
  readonly grams: number;
  readonly power: number;
  readonly motorStop: number | null;
}

function Result({ event, grams, power, motorStop }: ResultProps) {
  const rule = ENERGY_RULES[event];
  const { energy, energyBy, run, runBy } = allowanceFor(rule, grams, power);
  const figures: [string, string, string][] = [
    [
      words.allowed,
      words.joules(energy),
      energyBy === 'weight' ? words.energyBy.weight(rule.perGram) : words.energyBy.ceiling(rule.most),
    ],
    [words.run, secondsText(run), runBy === 'energy' ? words.runBy.energy : words.runBy.time(rule.longest)],
  ];
  return (
    <>
      <dl>
        {figures.map(([name, figure, why]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              <b>{figure}</b> <span>{why}</span>
            </dd>
          </div>
        ))}
      </dl>
      {motorStop !== null && (
        <p class={motorStop > run ? 'bad-text' : undefined}>
          {words.onScreen(secondsText(motorStop), energyOf(motorStop, power))}{' '}
          {motorStop > run ? words.beyond : words.within}
        </p>
      )}
    </>
  );
}

/** @param hundredths of a second */
function secondsText(hundredths: number): string {
  return words.seconds((hundredths / 100).toFixed(hundredths % 10 === 0 ? 1 : 2));
}
