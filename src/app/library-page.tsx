import { useEffect } from 'preact/hooks';
import { takeDroppedFiles } from './browser/dropped-files.js';
import { backupKey, COMPARE, SCREEN, settingKey, versionKey } from './compare/choice.js';
import { FLIGHTS } from './flights/flight-filter.js';
import { FlightsSection } from './flights/flights-section.js';
import { EarlierVersions } from './library/earlier-versions.js';
import { LibraryFileButtons } from './library/files/file-buttons.js';
import type { FilePart } from './library/files/library-text.js';
import { LibraryView } from './library/library-view.js';
import type { Places } from './library/places.js';
import { filesOf } from './library-files.js';
import { messages } from './messages/index.js';
import { moreMessages } from './messages/more.js';
import type { AppModels } from './models.js';
import { PrintButton } from './print/print-button.js';
import { sharedOf } from './work/setting-link.js';
import { BackupList } from './write/backup-list.js';

/** The library, with what other features put into it. */
export function LibraryPage({ models }: { readonly models: AppModels }) {
  const { session, views, browse } = models;
  useEffect(
    () => takeDroppedFiles((files) => views.shown.peek() === 'library' && void filesOf(models).import(files)),
    [models, views],
  );
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

/** One entry for each feature of the library, a model or a setting. */
function placesOf(models: AppModels): Places {
  const { session, views, flights, sharing, printOrder, comparedPair, follow } = models;
  const files = filesOf(models);
  const toFlights = (): void => views.show('library', FLIGHTS);
  const flightsOf = { session, log: flights, onAll: toFlights };
  const print = (keys: readonly string[]): void => {
    printOrder.choose(keys);
    views.show('print');
  };
  const sideBySide = (first: string, second: string | null = null): void => {
    comparedPair.show(first, second);
    views.show('library', COMPARE);
  };
  const button = (label: string, onClick: () => void) => (
    <button type="button" onClick={onClick}>
      {label}
    </button>
  );
  const exportButton = (part: FilePart, title: string) =>
    button(moreMessages.value.files.export.one, () => void files.export(part, title));
  return {
    library: (
      <>
        <ul class="panel ruled library-list">
          <li>
            <a class="stack library-item" href={`#library/${FLIGHTS}`} onClick={() => flights.showOnly()}>
              <b>{moreMessages.value.flights.title}</b>
            </a>
          </li>
        </ul>
        <div class="buttons">
          <LibraryFileButtons files={files} />
          {button(moreMessages.value.share.paste.title, () => sharing.paste())}
        </div>
      </>
    ),
    modelButtons: ({ key, model }) => (
      <>
        <PrintButton
          keys={session.library.settings.list.value
            .filter(({ setting }) => setting.model === key)
            .map((record) => record.key)}
          onPrint={print}
        />
        {exportButton({ kind: 'model', id: key }, model.name)}
      </>
    ),
    modelSections: (record) => (
      <>
        <FlightsSection {...flightsOf} of={{ kind: 'model', id: record.key, name: record.model.name }} />
        <BackupList
          session={session}
          of={record}
          following={follow.on.value}
          onLoad={() => views.show('program')}
          onCompare={({ key }) => sideBySide(backupKey(key))}
        />
      </>
    ),
    settingButtons: ({ key, setting }, model) => (
      <>
        {button(messages.value.views.share, () => sharing.offer(sharedOf(setting, model?.model ?? null)))}
        <PrintButton keys={[key]} onPrint={print} />
        {exportButton({ kind: 'setting', id: key }, [model?.model.name, setting.name].filter(Boolean).join(' '))}
        {button(moreMessages.value.compare.open, () =>
          sideBySide(session.origin.setting.peek()?.id === key ? SCREEN : settingKey(key)),
        )}
      </>
    ),
    settingSections: (record) => (
      <>
        <EarlierVersions
          session={session}
          record={record}
          onCompare={({ until }) => sideBySide(versionKey(record.key, until), settingKey(record.key))}
        />
        <FlightsSection {...flightsOf} of={{ kind: 'setting', id: record.key, name: record.setting.name }} />
      </>
    ),
  };
}
