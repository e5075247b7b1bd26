import { LibraryView } from './library/library-view.js';
import type { Places } from './library/places.js';
import type { AppModels } from './models.js';

/** The library, with what other features put into it. */
export function LibraryPage({ models }: { readonly models: AppModels }) {
  const { session, views, browse } = models;
  return (
    <LibraryView
      {...{ session, browse }}
      path={views.path.value}
      onProgram={() => views.show('program')}
      onGo={(path) => views.show('library', path)}
      places={placesOf(models)}
    />
  );
}

/** One entry for each thing that can be done with the library, a model or a setting beyond looking at it. */
function placesOf(_models: AppModels): Places {
  return {
    library: <></>,
    modelButtons: () => <></>,
    modelSections: () => <></>,
    settingButtons: () => <></>,
    settingSections: () => <></>,
  };
}
