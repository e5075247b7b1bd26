import { guide } from '../messages/en-guide.js';
import { HELP_PAGES, type HelpPage } from './help.js';
import './help-nav.css';

/** Links from one page of the help to the others. */
export function HelpNav({ shown }: { readonly shown: HelpPage }) {
  return (
    <nav class="row gap-4 help-nav" aria-label={guide.nav}>
      {HELP_PAGES.map((page) => (
        <a key={page} class="alone" href={`#help/${page}`} aria-current={page === shown ? 'page' : undefined}>
          {guide.pages[page]}
        </a>
      ))}
    </nav>
  );
}
