import { commandsOf } from './commands.js';
import { SaveDialog } from './library/save-dialog.js';
import { GoOn, LeaveDialog } from './memories/leave-dialog.js';
import { MemoriesDialog } from './memories/memories-dialog.js';
import type { AppModels } from './models.js';
import { ModelDialog } from './recognition/model-dialog.js';
import { EraseDialog } from './settings/erase-dialog.js';
import { NewsDialog } from './shell/news-dialog.js';
import { Palette } from './shell/palette.js';
import { WriteDialog } from './write/write-dialog.js';

/** What can lie over every view. */
export function Dialogs({ models }: { readonly models: AppModels }) {
  const { session, write, memories, leaving, erase, update, saveSetting } = models;
  return (
    <>
      <WriteDialog session={session} write={write} after={<GoOn write={write} leaving={leaving} />} />
      <MemoriesDialog session={session} jobs={memories.jobs} />
      <LeaveDialog session={session} leaving={leaving} />
      <ModelDialog recognition={session.recognition} />
      <SaveDialog session={session} saveSetting={saveSetting} />
      <EraseDialog session={session} erase={erase} />
      <NewsDialog update={update} />
      <Palette commands={() => commandsOf(models)} />
    </>
  );
}
