import { commandsOf } from './commands.js';
import { FlightDialog } from './flights/flight-dialog.js';
import { FlyingThis } from './flights/flying-this.js';
import { ImportDialog } from './library/files/import-dialog.js';
import { addressPath } from './library/place.js';
import { SaveDialog } from './library/save-dialog.js';
import { SharingDialog } from './library/share/sharing-dialog.js';
import { filesOf } from './library-files.js';
import { GoOn, LeaveDialog } from './memories/leave-dialog.js';
import type { AppModels } from './models.js';
import { ModelDialog } from './recognition/model-dialog.js';
import { EraseDialog } from './settings/erase-dialog.js';
import { PageKeys } from './shell/page-keys.js';
import { Palette } from './shell/palette.js';
import { WriteDialog } from './write/write-dialog.js';

/** The dialogs that can lie over every view. */
export function Dialogs({ models }: { readonly models: AppModels }) {
  const { session, views, sharing, write, leaving, flights, erase, saveSetting } = models;
  const after = (
    <>
      <FlyingThis session={session} log={flights} onFillIn={() => write.dismiss()} />
      <GoOn write={write} leaving={leaving} />
    </>
  );
  return (
    <>
      <WriteDialog session={session} write={write} after={after} />
      <FlightDialog session={session} log={flights} onProgram={() => views.show('program')} />
      <LeaveDialog session={session} leaving={leaving} />
      <ModelDialog recognition={session.recognition} />
      <SaveDialog session={session} saveSetting={saveSetting} />
      <ImportDialog files={filesOf(models)} onTaken={() => models.views.show('library')} />
      <SharingDialog
        session={session}
        sharing={sharing}
        asked={write.current}
        page={location.href}
        onProgram={() => views.show('program')}
        onLibrary={(model, key) => views.show('library', addressPath(model, key))}
      />
      <EraseDialog session={session} erase={erase} />
      <PageKeys views={views} />
      <Palette commands={() => commandsOf(models)} />
    </>
  );
}
