import { FLIGHTS } from './flights/flight-filter.js';
import { FlightsSection } from './flights/flights-section.js';
import { LibraryView } from './library/library-view.js';
import type { Places } from './library/places.js';
import { flightMessages } from './messages/flights.js';
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
function placesOf({ session, views, flights }: AppModels): Places {
  const toFlights = (): void => views.show('library', FLIGHTS);
  const flightsOf = { session, log: flights, onAll: toFlights };
  return {
    library: (
      <button
        type="button"
        onClick={() => {
          flights.showOnly();
          toFlights();
        }}
      >
        {flightMessages.value.title}
      </button>
    ),
    modelButtons: () => <></>,
    modelSections: ({ key }) => <FlightsSection {...flightsOf} of={{ model: key }} />,
    settingButtons: () => <></>,
    settingSections: ({ key }) => <FlightsSection {...flightsOf} of={{ setting: key }} />,
  };
}
