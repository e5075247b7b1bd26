import { useLayoutEffect, useRef } from 'preact/hooks';
import { clockText, messages } from '../messages/index.js';
import { lastRead } from '../session/known.js';
import { memoryText } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import type { Held } from '../session/standing.js';
import { heldName } from '../session/standing-text.js';
import { ProgramPair } from '../side-by-side/program-pair.js';
import { BackHead } from '../ui/back-head.js';
import { Select } from '../ui/choice.js';
import type { Compared, Memories } from './memories.js';
import './memory-comparison.css';

interface MemoryComparisonProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly compared: Compared;
}

/** Compares two memories: what differs, in figures and over time. Offers to copy one into the other. */
export function MemoryComparison({ session, memories, compared }: MemoryComparisonProps) {
  const { overview: words, memories: all, look, memoryName } = messages.value;
  const { first, second } = compared;
  const heading = useRef<HTMLHeadingElement>(null);
  useLayoutEffect(() => {
    // The card whose button opened it may be far down.
    document.documentElement.scrollTop = 0;
    heading.current?.focus({ preventScroll: true });
  }, []);
  const count = session.editor.baseline.value?.identity.memories ?? 0;
  const ready = session.runner.ready.value && !session.nextFlight.open.value;
  const held = [first, second].map((memory) => session.standings.of(memory)) as [Held, Held];
  const names = [
    heldName(memoryText(session, first), held[0], clockText),
    heldName(memoryText(session, second), held[1], clockText),
  ] as const;
  const [left, right] = held.map(({ known }) => lastRead(known));
  const unread = [first, second].filter((_, at) => held[at]?.known.state === 'unread');
  return (
    <section class="comparison" aria-labelledby="comparison-title">
      <BackHead back={words.all} to={() => memories.compare(null)} titleId="comparison-title" heading={heading}>
        {words.compared(memoryText(session, first), memoryText(session, second))}
      </BackHead>
      <div class="comparison-choice">
        <Choice
          label={words.from}
          {...{ count, chosen: first, other: second }}
          onChoose={(memory) => memories.compare({ first: memory, second })}
        />
        <Choice
          label={words.to}
          {...{ count, chosen: second, other: first }}
          onChoose={(memory) => memories.compare({ first, second: memory })}
        />
        <div class="buttons">
          {[
            { from: first, to: second },
            { from: second, to: first },
          ].map((copy) => (
            <button
              type="button"
              key={copy.from}
              disabled={!ready}
              onClick={() => void memories.jobs.open({ kind: 'copy', ...copy })}
            >
              {all.copy(memoryName(copy.from), memoryName(copy.to))}
            </button>
          ))}
        </div>
      </div>
      {unread.map((memory) => (
        <div class="comparison-unread" key={memory}>
          <p>{look.notRead(memoryName(memory))}</p>
          <button type="button" disabled={!ready} onClick={() => void memories.readOnce(memory)}>
            {look.look(memoryName(memory))}
          </button>
        </div>
      ))}
      {left && right && <ProgramPair first={left} second={right} names={names} title={words.picture(...names)} />}
    </section>
  );
}

interface ChoiceProps {
  readonly label: string;
  readonly count: number;
  readonly chosen: number;
  /** This memory cannot be chosen, because it is the other one. */
  readonly other: number;
  readonly onChoose: (memory: number) => void;
}

function Choice({ label, count, chosen, other, onChoose }: ChoiceProps) {
  return (
    <label>
      {label}
      <Select
        choices={Array.from({ length: count }, (_, memory) => memory).filter((memory) => memory !== other)}
        nameOf={messages.value.memoryName}
        chosen={chosen}
        onChoose={onChoose}
      />
    </label>
  );
}
