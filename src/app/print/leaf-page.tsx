import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { print } from '../messages/en-print.js';
import { TimelineNotes } from '../timeline/timeline-notes.js';
import { type Copy, type Piece, type SetLeaf, setSheet } from './galley.js';
import { LeafFlights } from './leaf-flights.js';
import type { Leaf } from './paper.js';
import type { Sheet } from './sheet.js';
import { SheetCode, SheetHead, SheetLines, SheetTable } from './sheet-parts.js';
import { SheetTimeline } from './sheet-timeline.js';
import './sheet.css';
import './leaf.css';

/** One page of a sheet. */
export function LeafPage({ set, printed }: { readonly set: SetLeaf; readonly printed: string }) {
  const { sheet, leaf, page, pages, pieces, empty } = set;
  return (
    <article class={classOf(leaf)}>
      <div class="leaf-body">
        {pieces.map((piece, at) => (
          <SheetPiece key={at} sheet={sheet} leaf={leaf} {...piece} />
        ))}
        {empty > 0 && (
          <div>
            <LeafFlights rows={empty} />
          </div>
        )}
      </div>
      <footer class="leaf-foot">
        <span>{print.continued(sheet.model, sheet.setting)}</span>
        <span>{print.printed(printed)}</span>
        <span>{print.page(page, pages)}</span>
      </footer>
    </article>
  );
}

function classOf({ name, width }: Leaf): string {
  return `leaf leaf-${name} paper ${width > 150 ? 'large' : ''}`;
}

type SheetPieceProps = Piece & { readonly sheet: Sheet; readonly leaf: Leaf };

function SheetPiece({ sheet, leaf, section, from, until }: SheetPieceProps) {
  const drawn = (): ComponentChildren => {
    switch (section.kind) {
      case 'head':
        return <SheetHead sheet={sheet} />;
      case 'table':
        return <SheetTable sheet={sheet} group={section.group} rows={sheet.rows.slice(from, until)} />;
      case 'timeline':
        return (
          <>
            <SheetTimeline program={sheet.program} servos={section.group} names={sheet.servos} leaf={leaf} />
            <TimelineNotes program={sheet.program} />
          </>
        );
      case 'code':
        return <SheetCode link={section.link} />;
      case 'warnings':
      case 'notes':
        return <SheetLines title={print[section.kind]} lines={section.lines.slice(from, until)} />;
    }
  };
  return <div class={`leaf-of-${section.kind}`}>{drawn()}</div>;
}

/**
 * Lays sheets out on pages: draws each once out of sight, measures it, and cuts it into pages.
 * @returns the pages, and the drawing that must be in the document for this.
 */
export function useLeaves(copies: readonly Copy[]): {
  readonly leaves: readonly SetLeaf[];
  readonly galley: ComponentChildren;
} {
  const galley = useRef<HTMLDivElement>(null);
  const leaves = useSignal<readonly SetLeaf[]>([]);
  useLayoutEffect(() => {
    const { current } = galley;
    if (!current) return;
    const set = (): void => {
      leaves.value = copies.flatMap((copy, at) => setSheet(current.children[at] as Element, copy));
    };
    set();
    // The font may load later than the text. While it prints, nothing can be measured.
    const observer = new ResizeObserver(() => current.offsetWidth > 0 && set());
    for (const body of current.querySelectorAll('.leaf-body')) observer.observe(body);
    return () => observer.disconnect();
  }, [copies, leaves]);
  return {
    leaves: leaves.value,
    galley: (
      <div class="galley" ref={galley} aria-hidden="true">
        {copies.map((copy) => (
          <GalleySheet key={copy.sheet.key} {...copy} />
        ))}
      </div>
    ),
  };
}

function GalleySheet({ sheet, leaf, sections, hasLines }: Copy) {
  return (
    <div>
      <div class={classOf(leaf)}>
        <div class="leaf-body">
          {sections.map((section, at) => (
            <SheetPiece
              key={at}
              section={section}
              sheet={sheet}
              leaf={leaf}
              from={0}
              until={Number.POSITIVE_INFINITY}
            />
          ))}
          {hasLines && (
            <div>
              <LeafFlights rows={1} />
            </div>
          )}
        </div>
      </div>
      <div class={`${classOf(leaf)} leaf-empty`}>
        <div class="leaf-room" />
      </div>
    </div>
  );
}
