import { useCallback, useEffect, useRef } from 'preact/hooks';
import { COMPARE } from './compare/address.js';
import { hasStage } from './connect/link-stage.js';
import { StartScreen } from './connect/start-screen.js';
import { FLIGHTS } from './flights/flight-filter.js';
import type { FirstSteps as FirstStepsModel } from './help/first-steps.js';
import { messages } from './messages/index.js';
import type { AppModels } from './models.js';
import * as parts from './parts.js';
import { Header } from './shell/header.js';
import { ViewFrame } from './shell/view-frame.js';
import { ViewLinks } from './shell/view-links.js';
import type { View } from './shell/views.js';
import { RecoveryPanel } from './write/recovery-panel.js';
import './app.css';

/** The whole page: hands to each of its parts the models that this part needs. */
export function App({ models }: { readonly models: AppModels }) {
  const { session, views, write, finishWrite, memories, leaving, bench, follow, erase, theme, platform } = models;
  const { preferences, density, programPicture, saveSetting, keeping, aside, update, portHolder, line, installation } =
    models;
  const { help } = models;
  const { views: words } = messages.value;
  const hasProgram = session.editor.identity.value !== null;
  const shown = views.shown.value;
  const isStart = !hasProgram && shown === 'program';
  // The same at each drawing: else the whole program is drawn with it.
  const print = useCallback(() => {
    models.printOrder.choose();
    views.show('print');
  }, [models, views]);
  // As the page came with it.
  const title = useRef(document.title);
  useEffect(() => {
    document.title = shown === 'program' ? title.current : words.window(words.names[shown], title.current);
    // For the styles of all that stands around a view.
    document.documentElement.setAttribute('data-view', shown);
  }, [shown, words]);
  const view: Record<View, () => preact.JSX.Element> = {
    program: () =>
      hasProgram ? (
        <parts.program.Part
          {...{ session, write, memories, bench, follow, preferences, programPicture, saveSetting }}
          sharing={models.sharing}
          onExplain={help.explainNow}
          onPrint={print}
        />
      ) : (
        <StartScreen {...{ session, installation, platform }}>
          <FirstSteps session={session} steps={help.steps} />
        </StartScreen>
      ),
    memories: () => (
      <parts.memories.Part
        {...{ session, memories }}
        following={follow.on.value}
        onProgram={() => views.show('program')}
      />
    ),
    bench: () => <parts.bench.Part {...{ session, views, write, bench, follow }} />,
    library: () =>
      views.path.value === FLIGHTS ? (
        <parts.flights.Part session={session} log={models.flights} />
      ) : views.path.value === COMPARE ? (
        <parts.compare.Part
          {...{ session, pair: models.comparedPair }}
          following={follow.on.value}
          onBack={() => views.show('library')}
        />
      ) : (
        <parts.library.Part models={models} />
      ),
    print: () => <parts.print.Part session={session} order={models.printOrder} onPrint={() => window.print()} />,
    help: () => <parts.help.Part {...{ session, help, platform }} path={views.path.value} />,
    line: () => <parts.line.Part session={session} view={line.view} form={line.form} />,
    settings: () => (
      <parts.settings.Part {...{ session, preferences, theme, density, erase, views, installation, update }} />
    ),
  };
  return (
    <>
      <Header
        {...{
          session,
          memories,
          leaving,
          follow,
          preferences,
          saveSetting,
          keeping,
          aside,
          update,
          portHolder,
          platform,
        }}
        installation={installation}
        fileNotice={<parts.fileNotice.Part models={models} />}
        onExport={() =>
          void parts
            .fetchFiles()
            .then(({ filesOf }) => filesOf(models).exportAll())
            .catch(() => {})
        }
        staged={isStart && hasStage(session)}
      />
      {!isStart && <ViewLinks views={views} />}
      <ViewFrame views={views} busy={session.runner.busy.value} whole={hasProgram && shown === 'program'}>
        <RecoveryPanel session={session} write={write} finishWrite={finishWrite} />
        {view[shown]()}
      </ViewFrame>
      <parts.dialogs.Part models={models} />
    </>
  );
}

/** For who comes here for the first time: whoever has something here has been here. */
function FirstSteps({ session, steps }: { readonly session: AppModels['session']; readonly steps: FirstStepsModel }) {
  const { backups, keptPrograms, library } = session;
  const isWanted = steps.shown.value !== null;
  useEffect(() => {
    if (isWanted) void library.load();
  }, [isWanted, library]);
  const isKnown = [backups.list, keptPrograms.list, library.models.list].some(({ value }) => value.length > 0);
  useEffect(() => {
    // The next time no room is kept for them.
    if (isKnown) steps.end();
  }, [isKnown, steps]);
  if (!isWanted || isKnown) return null;
  // Not before it is known what is here: nobody sees them come and go. Their room is there from the first picture on.
  return <div class="first-steps-room">{library.models.loaded.value && <parts.firstSteps.Part steps={steps} />}</div>;
}
