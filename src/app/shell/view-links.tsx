import type { ReadonlySignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { SHAPES } from '../ui/shapes.js';
import { useHeight } from '../ui/use-height.js';
import { useQuery } from '../ui/use-query.js';
import { ViewIcon } from './icons.js';
import { VIEWS, type View, type Views } from './views.js';
import './view-links.css';

interface ViewLinksProps {
  readonly views: Views;
  /** The view that what is printed comes from. */
  readonly printed: ReadonlySignal<View>;
}

/** Links to the views: a rail at the left, on a phone a bar at the bottom. */
export function ViewLinks({ views, printed }: ViewLinksProps) {
  const { views: words } = messages.value;
  const areBelow = useQuery(SHAPES.phone).value;
  const nav = useRef<HTMLElement>(null);
  useHeight(nav, areBelow ? '--tabs' : null, 57);
  const shown = views.shown.value;
  const wanted = VIEWS.filter((view) => view !== 'line' || views.expert.value || shown === 'line');
  // A view without a link here belongs to one that has.
  const home = shown === 'print' ? printed.value : shown === 'help' && areBelow ? 'settings' : shown;
  // A phone has no room for a sixth link: the settings lead to the help.
  const inRail = areBelow ? wanted : wanted.flatMap((view) => (view === 'settings' ? (['help', view] as const) : view));
  return (
    <nav class="view-links" aria-label={words.title} ref={nav}>
      {inRail.map((view) => (
        <a
          key={view}
          href={`#${view}`}
          class={`to-${view}`}
          aria-current={view === shown ? 'page' : view === home ? 'true' : undefined}
        >
          <ViewIcon view={view} />
          {words.names[view]}
        </a>
      ))}
    </nav>
  );
}
