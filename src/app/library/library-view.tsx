import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { SHAPES } from '../ui/shapes.js';
import { useQuery } from '../ui/use-query.js';
import type { Session } from '../work/session.js';
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

/** The pilot's models and settings. On a phone one part at a time, with a way back. */
export function LibraryView({ session, browse, path, places, onProgram, onGo }: LibraryViewProps) {
  const { views, parts } = messages.value;
  const { library } = session;
  useEffect(() => void library.load(), [library]);
  // Two parts stand side by side: the models and one of them, or its settings and one of those.
  const isWide = !useQuery(SHAPES.phone).value;
  const isLoaded = library.models.loaded.value && library.settings.loaded.value;
  const place = placeOf(path);
  const model = library.models.get(place.model) ?? null;
  usePlaces(path, !isWide && isLoaded);
  if (!isLoaded) {
    return (
      <section class="stack gap-3" aria-busy="true">
        <h1>{views.names.library}</h1>
        <p class="hint" role="status">
          {parts.coming}
        </p>
      </section>
    );
  }
  const unread = library.unread.value;
  const modelPage = model && <ModelPage {...{ session, places }} record={model} onGone={() => onGo('')} />;
  const settingPage = place.setting !== null && (
    <SettingPage
      key={place.setting}
      {...{ session, places, onProgram, onGo }}
      setting={library.settings.get(place.setting) ?? null}
      back={isWide ? null : place.model}
    />
  );
  return (
    <>
      {unread && <Unread library={library} />}
      <div class={isWide ? 'library library-pair' : 'library'}>
        {place.model === null ? (
          <ModelList {...{ session, browse, places, onGo }} alone={!isWide} />
        ) : (
          (isWide || !settingPage) && (
            <ModelColumn
              {...{ session, browse, places, model, onGo }}
              key={place.model}
              isLoose={place.model === NO_MODEL}
              chosen={place.setting}
            >
              {!isWide && modelPage}
            </ModelColumn>
          )
        )}
        {(isWide || settingPage) && (
          <section class="stack gap-3 library-detail">
            {settingPage || modelPage || (!unread && <LibraryBeginning {...{ session, browse }} />)}
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
      <p>{moreMessages.value.library.unread}</p>
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
