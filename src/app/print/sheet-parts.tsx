import type { ComponentChildren } from 'preact';
import { dotted } from '../messages/dotted.js';
import { print } from '../messages/en-print.js';
import { messages } from '../messages/index.js';
import { QrCode } from '../ui/qr-code.js';
import type { Sheet, SheetRow } from './sheet.js';

/** A name with more characters would take half of the page. */
const LONG = 24;

/** The name of the setting, and its key figures. */
export function SheetHead({ sheet }: { readonly sheet: Sheet }) {
  return (
    <div class="leaf-head">
      <div class="leaf-title">
        <h2 class={sheet.model.length > LONG ? 'is-long' : ''}>
          <Blank label={print.model} text={sheet.model} />
        </h2>
        <p class="leaf-name">
          <Blank label={print.setting} text={sheet.setting} />
        </p>
        <dl class="leaf-facts">
          <dt>{print.memory}</dt>
          <dd class="leaf-memory">{sheet.memory || <span class="leaf-blank" />}</dd>
          <dd>{print.timer(sheet.timer, sheet.firmware)}</dd>
          {sheet.simulated && <dd class="leaf-loud">{print.simulated}</dd>}
          {sheet.others.map(({ label, text }) => (
            <dd key={label}>
              {label} {text}
            </dd>
          ))}
        </dl>
        <p class="leaf-origin">{sheet.origin}</p>
      </div>
      <dl class="leaf-figures">
        {sheet.figures.map(({ label, text, isShort, was }) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>
              {text}
              <Was text={was} />
              {isShort && <strong class="leaf-loud">{print.shortDt}</strong>}
            </dd>
          </div>
        ))}
      </dl>
    </div>
  );
}

/** A name, or a line to write it on. */
function Blank({ label, text }: { readonly label: string; readonly text: string }) {
  if (text) return <>{text}</>;
  return (
    <span class="leaf-to-fill">
      {label} <span class="leaf-blank" />
    </span>
  );
}

/** The mark of a changed value: what it was. */
function Was({ text }: { readonly text: string }) {
  return text === '' ? null : <small class="leaf-was">{text}</small>;
}

/** With more servos their names stand below the table: above the columns there is no room. */
const NAMED_IN_HEAD = 4;

interface SheetTableProps {
  readonly sheet: Sheet;
  /** The servos in this table. */
  readonly group: readonly number[];
  readonly rows: readonly SheetRow[];
}

/** Functions with their times and the positions of servos. */
export function SheetTable({ sheet, group, rows }: SheetTableProps) {
  const { program, servoName } = messages.value;
  return (
    <>
      <table class={`leaf-table of-${group.length}`}>
        <caption class="visually-hidden">{program.tableCaption}</caption>
        <thead>
          <tr>
            <th scope="col" class="leaf-slot">
              {program.slot}
            </th>
            <th scope="col" class="leaf-time">
              {program.time}
            </th>
            <th scope="col" class="leaf-after">
              {print.after}
            </th>
            {group.map((servo) => (
              <th scope="col" key={servo}>
                {servoName(servo)}{' '}
                {group.length <= NAMED_IN_HEAD && sheet.servos[servo] && <small>{sheet.servos[servo]}</small>}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ key, kind, label, time, after, positions, was }) => (
            <tr key={key} class={`leaf-${kind}`}>
              <th scope="row">{label}</th>
              <td>
                {time}
                <Was text={was.time} />
              </td>
              <td>{after}</td>
              {kind === 'motor' ? (
                <td colSpan={group.length} />
              ) : (
                group.map((servo) => (
                  <td key={servo}>
                    {positions[servo]}
                    <Was text={was.positions[servo] ?? ''} />
                  </td>
                ))
              )}
            </tr>
          ))}
        </tbody>
      </table>
      <SheetLegend sheet={sheet} group={group} />
    </>
  );
}

/** Under a table: the units, and what the servos move if the head has no room for it. */
function SheetLegend({ sheet, group }: { readonly sheet: Sheet; readonly group: readonly number[] }) {
  const { program, servoName } = messages.value;
  const names = group.flatMap((servo) => (sheet.servos[servo] ? [`${servoName(servo)} ${sheet.servos[servo]}`] : []));
  const isAbsolute = ['B', 'E'].includes(sheet.program.identity.timerClass);
  return (
    <div class="leaf-legend">
      {group.length > NAMED_IN_HEAD && names.length > 0 && <p class="leaf-uses">{dotted(names)}</p>}
      <p>
        {print.positions} {isAbsolute && program.absolute}
      </p>
    </div>
  );
}

/** Sentences below a heading: all of them, or as many as the page has room for. */
export function SheetLines(props: { readonly title: string; readonly lines: readonly ComponentChildren[] }) {
  return (
    <div class="leaf-lines">
      <h3>{props.title}</h3>
      {props.lines.map((line, at) => (
        <p key={at}>{line || '\u00a0'}</p>
      ))}
    </div>
  );
}

/** The way back from paper: a phone reads the code and shows the setting. */
export function SheetCode({ link }: { readonly link: string }) {
  return (
    <div class="leaf-code">
      <QrCode text={link} label={print.code} />
      <p>{print.codeHint}</p>
    </div>
  );
}
