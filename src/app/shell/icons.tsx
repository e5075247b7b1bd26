import { Icon } from '../ui/icon.js';
import type { VIEWS } from './views.js';

type Linked = (typeof VIEWS)[number] | 'help';

/** One path for each view, in a square of 24. */
const PATHS: Readonly<Record<Linked, string>> = {
  program: 'M4 6h16M4 12h16M4 18h10',
  memories:
    'M5.5 4h4A1.5 1.5 0 0 1 11 5.5v4A1.5 1.5 0 0 1 9.5 11h-4A1.5 1.5 0 0 1 4 9.5v-4A1.5 1.5 0 0 1 5.5 4zM14.5 4h4A1.5 1.5 0 0 1 20 5.5v4a1.5 1.5 0 0 1-1.5 1.5h-4A1.5 1.5 0 0 1 13 9.5v-4A1.5 1.5 0 0 1 14.5 4zM5.5 13h4a1.5 1.5 0 0 1 1.5 1.5v4A1.5 1.5 0 0 1 9.5 20h-4A1.5 1.5 0 0 1 4 18.5v-4A1.5 1.5 0 0 1 5.5 13zM14.5 13h4a1.5 1.5 0 0 1 1.5 1.5v4a1.5 1.5 0 0 1-1.5 1.5h-4a1.5 1.5 0 0 1-1.5-1.5v-4a1.5 1.5 0 0 1 1.5-1.5z',
  bench: 'M5 12a4 4 0 1 0 8 0a4 4 0 1 0-8 0M13 12h8M9 8V3M9 21v-5',
  library: 'M5 4h4v16H5zM11 4h4v16h-4zM17 5l3 .7-3 14',
  line: 'M3 12h4l2-6 4 12 2-6h6',
  help: 'M9 9.2a3 3 0 1 1 4.2 2.8c-.8.4-1.2 1-1.2 1.8M12 17h.01M3 12a9 9 0 1 0 18 0a9 9 0 1 0-18 0',
  settings:
    'M8.8 12a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0-6.4 0M12 3v3M12 18v3M3 12h3M18 12h3M5.6 5.6l2 2M16.4 16.4l2 2M18.4 5.6l-2 2M7.6 16.4l-2 2',
};

export function ViewIcon({ view }: { readonly view: Linked }) {
  return <Icon path={PATHS[view]} width={24} height={24} />;
}
