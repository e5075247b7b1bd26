import { messages } from './messages/index.js';
import { type AppModels, Models } from './models.js';
import { Header } from './parts/header.js';
import { RecoveryPanel } from './parts/recovery-panel.js';
import { ThemeChoice } from './parts/theme-choice.js';
import { EraseDialog } from './screens/erase-dialog.js';
import { LeaveDialog } from './screens/leave-dialog.js';
import { LinePanel } from './screens/line-panel.js';
import { MemoriesDialog } from './screens/memories-dialog.js';
import { ProgramScreen } from './screens/program-screen.js';
import { StartScreen } from './screens/start-screen.js';
import { WriteDialog } from './screens/write-dialog.js';

export function App({ models }: { models: AppModels }) {
  const { session } = models;
  const hasProgram = session.editor.identity.value !== null;
  return (
    <Models.Provider value={models}>
      <Header />
      <main>
        <RecoveryPanel />
        {hasProgram ? <ProgramScreen /> : <StartScreen />}
        <LinePanel />
      </main>
      <footer class="foot">
        <ThemeChoice />
        <button type="button" class="quiet" onClick={() => void models.erase.open()}>
          {messages.value.erase.open}
        </button>
      </footer>
      <WriteDialog />
      <MemoriesDialog />
      <LeaveDialog />
      <EraseDialog />
    </Models.Provider>
  );
}
