import { StartScreen } from './connect/start-screen.js';
import { LinePanel } from './line/line-panel.js';
import { LeaveDialog } from './memories/leave-dialog.js';
import { MemoriesDialog } from './memories/memories-dialog.js';
import { messages } from './messages/index.js';
import { type AppModels, Models } from './models.js';
import { EraseDialog } from './settings/erase-dialog.js';
import { ThemeChoice } from './settings/theme-choice.js';
import { Header } from './shell/header.js';
import { ProgramPage } from './shell/program-page.js';
import { RecoveryPanel } from './write/recovery-panel.js';
import { WriteDialog } from './write/write-dialog.js';

export function App({ models }: { models: AppModels }) {
  const { session } = models;
  const hasProgram = session.editor.identity.value !== null;
  return (
    <Models.Provider value={models}>
      <Header />
      <main>
        <RecoveryPanel />
        {hasProgram ? <ProgramPage /> : <StartScreen />}
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
