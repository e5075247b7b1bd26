import type { Platform } from '../browser/platform.js';
import type { HelpCode } from '../connect/connection-help.js';
import { connectionSaid, HelpSteps } from '../connect/connection-help-view.js';
import type { Checklist } from '../help/checklist.js';
import { ChecklistPage } from '../help/checklist-page.js';
import { HELP_PAGES, type HelpPage, helpPageAt } from '../help/help.js';
import { type Symptom, TroublePage } from '../help/trouble-page.js';
import { WordsPage } from '../help/words-page.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { NoticeText } from '../ui/notice-text.js';
import type { Session } from '../work/session.js';
import './help-view.css';

export interface HelpViewProps {
  readonly session: Session;
  readonly checklist: Checklist;
  readonly platform: Platform;
  /** The page of the help, as in the address. */
  readonly path: string;
}

/** What a pilot can look up, also on the field. */
export function HelpView({ session, checklist, platform, path }: HelpViewProps) {
  const { firstSteps, guide } = moreMessages.value;
  const shown = helpPageAt(path);
  const pages: Record<HelpPage, () => preact.JSX.Element> = {
    checklist: () => <ChecklistPage checklist={checklist} session={session} />,
    trouble: () => (
      <TroublePage connection={(symptom) => <Connection session={session} platform={platform} symptom={symptom} />} />
    ),
    words: () => <WordsPage />,
    steps: () => (
      <ol class="stack gap-4">
        {Object.values(firstSteps).map((step) => (
          <li key={step}>{step}</li>
        ))}
      </ol>
    ),
  };
  return (
    <>
      <h1>{messages.value.views.names.help}</h1>
      <nav class="row gap-4 help-nav" aria-label={guide.nav}>
        {HELP_PAGES.map((page) => (
          <a key={page} class="alone" href={`#help/${page}`} aria-current={page === shown ? 'page' : undefined}>
            {guide.pages[page]}
          </a>
        ))}
      </nav>
      <section class="stack help-page" aria-labelledby="help-page-title">
        <h2 id="help-page-title">{guide.pages[shown]}</h2>
        {pages[shown]()}
      </section>
    </>
  );
}

/** For a symptom of the connection: the help that the page shows when it happens. */
const CODES: Partial<Readonly<Record<Symptom, HelpCode>>> = {
  noAnswer: 'waiting',
  noAdapter: 'nothing-chosen',
  refused: 'busy',
  cutOff: 'lost',
};

interface ConnectionProps extends Pick<HelpViewProps, 'session' | 'platform'> {
  readonly symptom: Symptom;
}

function Connection({ session, platform, symptom }: ConnectionProps) {
  const asked = CODES[symptom];
  if (!asked) return null;
  const { unavailable } = session.link;
  const code = unavailable && symptom === 'noAdapter' ? unavailable : asked;
  return (
    <div class="help">
      {code === unavailable && <NoticeText said={connectionSaid(unavailable, platform)} />}
      <HelpSteps code={code} platform={platform} info={null} link={session.link} />
    </div>
  );
}
