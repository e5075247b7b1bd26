import { useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { print as words } from '../messages/en-print.js';
import { dateText, messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { BackHead } from '../ui/back-head.js';
import { Problem } from '../ui/problem.js';
import type { SetLeaf } from './galley.js';
import { LeafPage, useLeaves } from './leaf-page.js';
import { leavesOn, type Paper } from './paper.js';
import { Print } from './print.js';
import { PrintChoices } from './print-choices.js';
import type { PrintOrder } from './print-order.js';
import { PrintPicker } from './print-picker.js';
import './print-view.css';

export interface PrintViewProps {
  readonly session: Session;
  readonly order: PrintOrder;
  /** Opens the print window of the browser. */
  readonly onPrint: () => void;
}

/** The setting sheets as the printer will print them. */
export function PrintView({ session, order, onPrint }: PrintViewProps) {
  const print = useMemo(() => new Print(session, order, location.href), [session, order]);
  const { leaves, galley } = useLeaves(print.copies.value);
  const printed = useMemo(() => dateText(Date.now()), [leaves]);
  const failed = useSignal(false);
  const paper = print.paper.value;
  const pages = onPaper(leaves, leavesOn(paper));
  const { value: missing } = print.missing;
  const { value: left } = print.left;
  const { value: home } = order.home;
  return (
    <>
      <div class="print-tools">
        <BackHead back={messages.value.views.names[home]} to={`#${home}`}>
          {words.title}
        </BackHead>
        <p class="hint">{words.lead}</p>
        <PrintChoices print={print} />
        {left > 0 && <p role="status">{words.left(left)}</p>}
        {missing > 0 && <p role="status">{words.missing(missing)}</p>}
        <div class="buttons">
          <button
            type="button"
            class="primary"
            disabled={pages.length === 0}
            onClick={() => {
              try {
                onPrint();
                failed.value = false;
              } catch {
                failed.value = true;
              }
            }}
          >
            {words.print(pages.length)}
          </button>
        </div>
        <Problem text={failed.value && words.failed} />
        <PrintPicker print={print} />
      </div>
      {pages.length === 0 ? <p>{words.nothing}</p> : <Preview {...{ pages, paper, printed }} />}
      {galley}
    </>
  );
}

/** The pages on each sheet of paper. */
function onPaper(leaves: readonly SetLeaf[], each: number): readonly (readonly SetLeaf[])[] {
  return Array.from({ length: Math.ceil(leaves.length / each) }, (_, at) => leaves.slice(at * each, (at + 1) * each));
}

interface PreviewProps {
  readonly pages: readonly (readonly SetLeaf[])[];
  readonly paper: Paper;
  readonly printed: string;
}

/** The pages, as large as the room allows. */
function Preview({ pages, paper, printed }: PreviewProps) {
  const frame = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const { current } = frame;
    if (!current) return;
    const scale = (): void => {
      const page = current.querySelector<HTMLElement>('.print-page');
      if (!page || current.clientWidth === 0) return;
      current.style.setProperty('--fit', '1');
      const share = Math.min(1, current.clientWidth / page.offsetWidth);
      current.style.setProperty('--fit', String(share));
    };
    scale();
    const observer = new ResizeObserver(scale);
    observer.observe(current);
    return () => observer.disconnect();
  }, [paper]);
  return (
    <section class="print-preview" aria-label={words.preview} ref={frame}>
      {pages.map((leaves, at) => (
        <div key={at} class={`print-page on-${paper} paper`}>
          {leaves.map((leaf) => (
            <LeafPage key={`${leaf.sheet.key} ${leaf.page}`} set={leaf} printed={printed} />
          ))}
        </div>
      ))}
    </section>
  );
}
