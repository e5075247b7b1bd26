import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import { Header } from './parts/header.js';
import { LinePanel } from './screens/line-panel.js';
import { ProgramScreen } from './screens/program-screen.js';
import { StartScreen } from './screens/start-screen.js';
import { WriteDialog } from './screens/write-dialog.js';
import type { Session } from './state/session.js';
import type { UpdateOffer } from './state/update-offer.js';
import type { WriteFlow } from './state/write-flow.js';

/** The models that the screens read and call. */
export interface AppModels {
  readonly session: Session;
  readonly write: WriteFlow;
  readonly update: UpdateOffer;
}

const Models = createContext<AppModels | null>(null);

/** The models of the program that this component is part of. */
export function useModels(): AppModels {
  const models = useContext(Models);
  if (!models) throw new Error('outside of the app');
  return models;
}

export function App({ models }: { models: AppModels }) {
  const { session } = models;
  const hasProgram = session.editor.working.value !== null;
  const hasLine = session.log.entries.value.length > 0;
  return (
    <Models.Provider value={models}>
      <Header />
      <main>
        {hasProgram ? <ProgramScreen /> : <StartScreen />}
        {hasLine && <LinePanel />}
      </main>
      <WriteDialog />
    </Models.Provider>
  );
}
