import { useMemo } from 'preact/hooks';
import { dateText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { BackHead } from '../ui/back-head.js';
import { Check } from '../ui/check.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import type { Session } from '../work/session.js';
import { Print, SHEET_PARTS, type SheetPart } from './print.js';
import { PAPER_KEYS, PAPERS, type PrintOrder } from './print-order.js';
import { PrintPicker } from './print-picker.js';
import { SheetPaper } from './sheet-paper.js';
import './print-view.css';

export interface PrintViewProps {
  readonly session: Session;
  readonly order: PrintOrder;
}

/** The sheets of programs: what is shown below the choices is what is printed. */
export function PrintView({ session, order }: PrintViewProps) {
  const print = useMemo(() => new Print(session, order, location.href), [session, order]);
  const { value: sheets } = print.sheets;
  const printed = useMemo(() => dateText(Date.now()), [sheets]);
  const { views, timeline } = messages.value;
  const { print: words } = moreMessages.value;
  const parts: Readonly<Record<SheetPart, string>> = { timeline: timeline.title, notes: words.notes, ...words.parts };
  const { value: home } = order.home;
  return (
    <>
      <div class="stack gap-3 print-tools">
        <BackHead back={views.names[home]} to={`#${home}`}>
          {views.names.print}
        </BackHead>
        <SegmentChoice
          name="paper"
          title={words.paper}
          choices={PAPER_KEYS}
          names={PAPERS}
          chosen={print.paper.value}
          onChoose={(paper) => print.setPaper(paper)}
        />
        <fieldset class="row gap-4">
          <legend class="hint">{words.what}</legend>
          {SHEET_PARTS.map((part) => (
            <Check key={part} checked={print.parts.value.has(part)} onChange={() => print.togglePart(part)}>
              {parts[part]}
            </Check>
          ))}
        </fieldset>
        <div class="buttons">
          <button type="button" class="primary" disabled={sheets.length === 0} onClick={() => window.print()}>
            {views.print}
          </button>
        </div>
        <PrintPicker session={session} print={print} />
      </div>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: keys scroll it on a phone */}
      <div class="stack gap-4 print-sheets" tabIndex={0}>
        {sheets.length === 0 && <p>{words.nothing}</p>}
        {sheets.map((sheet) => (
          <SheetPaper
            key={sheet.key}
            sheet={sheet}
            paper={print.paper.value}
            parts={print.parts.value}
            printed={printed}
          />
        ))}
      </div>
    </>
  );
}
