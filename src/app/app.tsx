import { StartScreen } from './connect/start-screen.js';
import { LinePanel } from './line/line-panel.js';
import { LeaveDialog } from './memories/leave-dialog.js';
import { MemoriesDialog } from './memories/memories-dialog.js';
import { messages } from './messages/index.js';
import type { AppModels } from './models.js';
import { EraseDialog } from './settings/erase-dialog.js';
import { ThemeChoice } from './settings/theme-choice.js';
import { Header } from './shell/header.js';
import { ProgramPage } from './shell/program-page.js';
import { RecoveryPanel } from './write/recovery-panel.js';
import { WriteDialog } from './write/write-dialog.js';
import './app.css';

/** The whole page: hands to each of its parts the models that this part needs. */
export function App({ models }: { readonly models: AppModels }) {
  const { session, write, finishWrite, memories, leaving, bench, follow, erase, theme, platform } = models;
  const { preferences, keeping, aside, update, portHolder } = models;
  const hasProgram = session.editor.identity.value !== null;
  return (
    <>
      <Header {...{ session, memories, leaving, keeping, aside, update, portHolder, platform }} />
      <main>
        <RecoveryPanel session={session} write={write} finishWrite={finishWrite} />
        {hasProgram ? (
          <ProgramPage {...{ session, write, memories, bench, follow, preferences }} />
        ) : (
          <StartScreen session={session} platform={platform} />
        )}
        <LinePanel session={session} />
      </main>
      <footer class="foot">
        <ThemeChoice theme={theme} />
        <button type="button" class="quiet" onClick={() => void erase.open()}>
          {messages.value.erase.open}
        </button>
      </footer>
      <WriteDialog session={session} write={write} />
      <MemoriesDialog session={session} jobs={memories.jobs} />
      <LeaveDialog session={session} leaving={leaving} />
      <EraseDialog session={session} erase={erase} />
    </>
  );
}
