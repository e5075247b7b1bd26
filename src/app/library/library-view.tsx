import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { libraryMessages } from '../messages/en-library.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useQuery } from '../ui/use-query.js';
import type { Browse } from './browse.js';
import { LibraryBeginning } from './library-beginning.js';
import { ModelColumn } from './model-column.js';
import { ModelList } from './model-list.js';
import { ModelPage } from './model-page.js';
import { NO_MODEL, placeOf } from './place.js';
import type { Places } from './places.js';
import { SettingPage } from './setting-page.js';
import './library-view.css';

export interface LibraryViewProps {
  readonly session: Session;
  readonly browse: Browse;
  /** The place in the library, see `placeOf`. */
  readonly path: string;
  readonly places: Places;
  /** Shows the program that was opened. */
  readonly onProgram: () => void;
  /** Goes to another place of the library. */
  readonly onGo: (path: string) => void;
}

/** From this width on, models, settings and one setting stand side by side; from the second width on, two of them. */
const WIDE = '(min-width: 1100px) and (min-height: 480px)';
const MIDDLE = '(min-width: 760px)';

/**
 * The pilot's models and settings. Side by side where there is room: the models, the settings of one, and what is
 * chosen. On a phone one of these, with a way back.
 */
export function LibraryView({ session, browse, path, places, onProgram, onGo }: LibraryViewProps) {
  const { views, parts } = messages.value;
  const { library } = session;
  useEffect(() => void library.load(), [library]);
  const isWide = useQuery(WIDE).value;
  const isMiddle = useQuery(MIDDLE).value;
  const isLoaded = library.models.loaded.value && library.settings.loaded.value;
  const place = placeOf(path);
  const model = library.models.get(place.model) ?? null;
  const setting = library.settings.get(place.setting) ?? null;
  const depth = place.setting !== null ? 2 : place.model !== null ? 1 : 0;
  const columns = isWide ? 3 : isMiddle ? 2 : 1;
  const shows = (level: 0 | 1 | 2): boolean =>
    columns === 3 || (columns === 2 ? (depth === 0 ? level !== 1 : level !== 0) : level === depth);
  const one = columns === 1;
  usePlaces(path, one && isLoaded);
  if (!isLoaded) {
    return (
      <section class="library-coming" aria-busy="true">
        <h1>{views.names.library}</h1>
        <p class="hint" role="status">
          {parts.coming}
        </p>
      </section>
    );
  }
  const unread = library.unread.value;
  return (
    <>
      {unread && <Unread library={library} />}
      <div class={`library columns-${columns} ${place.model === null ? 'no-model' : ''}`}>
        {shows(0) && (
          <ModelList
            {...{ session, browse, places, onGo }}
            alone={one}
            foundBeside={!one && depth === 0 && !unread}
            chosen={place.model}
            setting={place.setting}
          />
        )}
        {shows(1) && (columns < 3 || place.model !== null) && (
          <ModelColumn
            {...{ session, browse, places, model, onGo }}
            key={place.model}
            isLoose={place.model === NO_MODEL}
            chosen={place.setting}
            back={columns < 3}
          >
            {one && model && <ModelPage {...{ session, places }} record={model} onGone={() => onGo('')} />}
          </ModelColumn>
        )}
        {shows(2) && !one && depth < 2 && (
          <section class="library-detail">
            {model ? (
              <ModelPage {...{ session, places }} record={model} onGone={() => onGo('')} />
            ) : (
              !unread && <LibraryBeginning {...{ session, browse }} />
            )}
          </section>
        )}
        {shows(2) && depth === 2 && (
          <section class="library-detail">
            <SettingPage
              key={place.setting}
              {...{ session, setting, places, onProgram, onGo }}
              back={one ? place.model : null}
            />
          </section>
        )}
      </div>
    </>
  );
}

/** Entries that were not read must not look as if they were missing. */
function Unread({ library }: { readonly library: Session['library'] }) {
  return (
    <div class="notice bad" role="alert">
      <p>{libraryMessages.unread}</p>
      <button type="button" onClick={() => void library.load()}>
        {messages.value.parts.again}
      </button>
    </div>
  );
}

/**
 * Moves the focus to a new place, unless it is in sight already. On a phone each place begins at its top; a pilot who
 * comes back finds it scrolled as before.
 */
function usePlaces(path: string, scrolls: boolean): void {
  const places = useRef(new Map<string, number>());
  const before = useRef(path);
  useLayoutEffect(() => {
    if (before.current !== path && (document.activeElement ?? document.body) === document.body) {
      document.querySelector('main')?.focus({ preventScroll: true });
    }
    before.current = path;
    if (!scrolls) return;
    const page = document.documentElement;
    page.scrollTop = places.current.get(path) ?? 0;
    const note = (): void => void places.current.set(path, page.scrollTop);
    addEventListener('scroll', note, { passive: true });
    return () => removeEventListener('scroll', note);
  }, [path, scrolls]);
}
