import { useCallback, useEffect, useRef } from 'preact/hooks';
import type { ProgramField } from '../program/index.js';
import { backupKey, COMPARE, memoryKey } from './compare/choice.js';
import { ConnectButtons } from './connect/connect-buttons.js';
import { hasStage } from './connect/link-stage.js';
import { StartScreen } from './connect/start-screen.js';
import { FLIGHTS } from './flights/flight-filter.js';
import { messages } from './messages/index.js';
import type { AppModels } from './models.js';
import * as parts from './parts.js';
import { PrintMemories } from './print/print-button.js';
import { Header } from './shell/header.js';
import { ViewFrame } from './shell/view-frame.js';
import { ViewLinks } from './shell/view-links.js';
import type { View } from './shell/views.js';
import './app.css';

/** The whole page: gives each part the models that it needs. */
export function App({ models }: { readonly models: AppModels }) {
  const { session, views, follow, line } = models;
  const { views: words } = messages.value;
  const hasProgram = session.editor.identity.value !== null;
  const shown = views.shown.value;
  const isStart = !hasProgram && shown === 'program';
  // The same function at each drawing; otherwise the whole program would be drawn again.
  const print = useCallback(
    (keys?: readonly string[]) => {
      models.printOrder.choose(keys);
      views.show('print');
    },
    [models, views],
  );
  const compare = (first: string, second: string | null): void => {
    models.comparedPair.show(first, second);
    views.show('library', COMPARE);
  };
  const printProgram = useCallback(() => print(), [print]);
  const toField = (field: ProgramField): void => {
    models.memories.endLook();
    models.programPicture.seek(field);
    views.show('program');
  };
  // The title that the page came with.
  const title = useRef(document.title);
  useEffect(() => {
    document.title = shown === 'program' ? title.current : `${words.names[shown]} · ${title.current}`;
    // For the styles of everything around a view.
    document.documentElement.setAttribute('data-view', shown);
  }, [shown, words]);
  // Where a view asks for a timer.
  const connect = <ConnectButtons session={session} part="first" />;
  const view: Record<View, () => preact.JSX.Element> = {
    program: () =>
      hasProgram ? (
        <parts.Program
          {...models}
          onPrint={printProgram}
          flying={<parts.FlyingThis session={session} log={models.flights} />}
        />
      ) : (
        <StartScreen {...models} />
      ),
    memories: () => (
      <parts.Memories
        {...models}
        connect={connect}
        print={<PrintMemories session={session} onPrint={print} />}
        following={follow.on.value}
        onProgram={() => views.show('program')}
        onCompare={(first, second) => compare(memoryKey(first), memoryKey(second))}
        onCompareBackup={({ key }) => compare(backupKey(key), null)}
      />
    ),
    bench: () => (
      <>
        <h1>{words.names.bench}</h1>
        {hasProgram ? (
          <parts.Bench {...models} expert={views.expert.value} />
        ) : (
          <>
            <p class="hint">{words.noTimer.bench}</p>
            <div>{connect}</div>
          </>
        )}
      </>
    ),
    library: () =>
      views.path.value === FLIGHTS ? (
        <parts.Flights session={session} log={models.flights} />
      ) : views.path.value === COMPARE ? (
        <parts.Compare session={session} pair={models.comparedPair} following={follow.on.value} />
      ) : (
        <parts.Library models={models} />
      ),
    print: () => <parts.Print session={session} order={models.printOrder} />,
    help: () => <parts.Help {...models} path={views.path.value} />,
    line: () => <parts.Line session={session} view={line.view} form={line.form} />,
    settings: () => <parts.Settings {...models} />,
  };
  return (
    <>
      <Header
        {...models}
        recognized={<parts.Recognized recognition={session.recognition} />}
        fileNotice={parts.allElse.hasFailed ? <NoDialogs /> : <parts.FileNotice models={models} />}
        onExport={() =>
          void parts
            .fetchFiles()
            .then(({ filesOf }) => filesOf(models).export())
            .catch(() => {})
        }
        staged={isStart && hasStage(session)}
        onField={toField}
      />
      {!isStart && <ViewLinks views={views} printed={models.printOrder.home} />}
      <ViewFrame views={views} busy={session.runner.busy.value} whole={hasProgram && shown === 'program'}>
        {view[shown]()}
      </ViewFrame>
      <parts.Dialogs models={models} />
    </>
  );
}

/** The dialogs did not come: a link, a file or a click that waits for one must not wait in silence. */
function NoDialogs() {
  const { parts: words } = messages.value;
  return (
    <div class="notice bad" role="alert">
      <p>{words.failed}</p>
      <button type="button" onClick={() => void parts.fetchParts()}>
        {words.again}
      </button>
    </div>
  );
}
