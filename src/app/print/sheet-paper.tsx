import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { dotted } from '../messages/dotted.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { onPaper } from '../timeline/geometry.js';
import { Picture } from '../timeline/picture.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { TimelineNotes } from '../timeline/timeline-notes.js';
import { QrCode } from '../ui/qr-code.js';
import type { SheetPart } from './print.js';
import type { Paper } from './print-order.js';
import type { Sheet } from './sheet.js';
import './sheet.css';

interface SheetPaperProps {
  readonly sheet: Sheet;
  readonly paper: Paper;
  readonly parts: ReadonlySet<SheetPart>;
  /** The date of today. */
  readonly printed: string;
}

/**
 * The sheet of a program, as it is shown and as it is printed. The browser breaks it into pages: its outer table has
 * the names in its head, which stands on each of them, so that no page is mistaken for one of another model.
 */
export function SheetPaper({ sheet, paper, parts, printed }: SheetPaperProps) {
  const { print: words } = moreMessages.value;
  const { program, note, warnings, link } = sheet;
  return (
    <table role="presentation" class={`paper leaf on-${paper}`}>
      <thead>
        <tr>
          <td class="leaf-names">
            <span>{dotted([sheet.model, sheet.name, sheet.memory])}</span>{' '}
            <span>{words.printed({ date: printed })}</span>
          </td>
        </tr>
      </thead>
      <tbody>
        <tr>
          <td class="leaf-room">
            <article class="leaf-body">
              <SheetHead sheet={sheet} />
              {warnings.length > 0 && (
                <div class="leaf-warnings">
                  <SheetLines title={words.warnings} lines={warnings} />
                </div>
              )}
              {servoGroups(program.positions.length).map((group) => (
                <div key={group[0] ?? 0}>
                  <SheetTable sheet={sheet} group={group} />
                  {parts.has('timeline') && group.length > 0 && <SheetTimeline sheet={sheet} group={group} />}
                </div>
              ))}
              {parts.has('timeline') && <TimelineNotes program={program} />}
              {parts.has('notes') && note.some(Boolean) && <SheetLines title={words.notes} lines={note} />}
              {parts.has('code') && link !== null && (
                <div class="leaf-code">
                  <QrCode text={link} label={words.parts.code} />
                  <p>{words.codeHint}</p>
                </div>
              )}
              {parts.has('lines') && <SheetFlights />}
            </article>
          </td>
        </tr>
      </tbody>
    </table>
  );
}

/** The names, and the key figures. */
function SheetHead({ sheet }: { readonly sheet: Sheet }) {
  return (
    <div class="leaf-head">
      <div class="leaf-title">
        <h2>
          <Blank label={messages.value.label.model} text={sheet.model} />
        </h2>
        <p class="leaf-name">
          <Blank label={messages.value.views.names.program} text={sheet.name} />
        </p>
      </div>
      <dl class="leaf-figures">
        {sheet.figures.map(({ label, text, isShort, was }) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd>
              {text}
              {was && <small class="leaf-was">{was}</small>}
              {isShort && <strong class="leaf-loud">{messages.value.program.shortDt}</strong>}
            </dd>
          </div>
        ))}
      </dl>
      <p class="row">
        <span>
          {messages.value.program.memory} <strong>{sheet.memory || <span class="leaf-blank" />}</strong>
        </span>{' '}
        <span>{dotted([sheet.timer, ...sheet.others.map(({ label, text }) => `${label} ${text}`)])}</span>
        {sheet.simulated && <span class="leaf-loud">{moreMessages.value.print.simulated}</span>}
      </p>
      <p class="hint sentence leaf-origin">{sheet.origin}</p>
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

/** How many servos stand beside each other in a table. */
const SERVOS = 8;

/** Divides the servos into tables: as few as possible, and of about equal width. */
export function servoGroups(servos: number): readonly (readonly number[])[] {
  const tables = Math.max(1, Math.ceil(servos / SERVOS));
  const each = Math.ceil(servos / tables);
  return Array.from({ length: tables }, (_, table) =>
    Array.from({ length: Math.min(each, servos - table * each) }, (_, i) => table * each + i),
  );
}

interface GroupProps {
  readonly sheet: Sheet;
  /** The servos that stand beside each other. */
  readonly group: readonly number[];
}

/** Functions with their times and the positions of servos. */
function SheetTable({ sheet: { program, servos, was }, group }: GroupProps) {
  const { tableCaption, absolute } = messages.value.program;
  return (
    <div class="leaf-table">
      <ProgramGrid
        program={program}
        caption={tableCaption}
        columns={[TIME_COLUMN, INTERVAL_COLUMN, ...group.map((servo) => FIRST_SERVO_COLUMN + servo)]}
        uses={servos}
        below={(value) => (value.kind === 'interval' ? '' : was(value))}
      />
      {['B', 'E'].includes(program.identity.timerClass) && <p>{absolute}</p>}
    </div>
  );
}

/** The program over time. Each lane has its name, so no colour is needed. */
function SheetTimeline({ sheet: { program, servos }, group }: GroupProps) {
  const geometry = onPaper(program, group, servos);
  const { width, height } = geometry.measures;
  return (
    <svg class="picture" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={messages.value.timeline.picture}>
      <Picture {...geometry} />
    </svg>
  );
}

/** Sentences below a heading. */
function SheetLines({ title, lines }: { readonly title: string; readonly lines: readonly string[] }) {
  return (
    <div class="leaf-lines">
      <h3>{title}</h3>
      {lines.map((line, at) => (
        <p key={at} class="as-typed">
          {line || '\u00a0'}
        </p>
      ))}
    </div>
  );
}

/** As many fit below a usual program on A5. */
const FLIGHTS = 3;

/** Empty rows to write flights into by hand. */
function SheetFlights() {
  const { date, round, wind, temperature, result, note } = moreMessages.value.flights.csv.columns;
  const columns = [date, round, wind, temperature, result, note];
  return (
    <table class="leaf-flights">
      <caption>{moreMessages.value.flights.title}</caption>
      <thead>
        <tr>
          {columns.map((column) => (
            <th scope="col" key={column}>
              {column}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {Array.from({ length: FLIGHTS }, (_, row) => (
          <tr key={row}>
            {columns.map((column) => (
              <td key={column} />
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
