import { COMPARE } from './compare/choice.js';
import { FLIGHTS } from './flights/flight-filter.js';
import type { SaveSetting } from './library/save-setting.js';
import { offerScreen } from './library/share/share-screen.js';
import { filesOf } from './library-files.js';
import { messages, stepText } from './messages/index.js';
import { moreMessages } from './messages/more.js';
import { programOf } from './messages/names.js';
import type { AppModels } from './models.js';
import type { PaletteCommand } from './shell/palette.js';
import { VIEWS } from './shell/views.js';
import type { Session } from './work/session.js';
import { readShown } from './write/edit-memory.js';

/** The commands that are possible now, the most wanted first. What stands on the screen of one view only has none. */
export function commandsOf(models: AppModels): readonly PaletteCommand[] {
  return [...programCommands(models), ...timerCommands(models), ...libraryCommands(models), ...viewCommands(models)];
}

/** “Ctrl+Z” */
const ctrl = (key: string): string => messages.value.palette.ctrl({ key });

function programCommands(models: AppModels): PaletteCommand[] {
  const { session, write, views, printOrder, saveSetting, sharing } = models;
  const { editor, runner, connection } = session;
  const { program, edits, views: words } = messages.value;
  const identity = editor.identity.value;
  if (!identity || write.current.value) return [];
  const isFree = !runner.busy.value;
  const { value: undo } = editor.undoStep;
  const { value: redo } = editor.redoStep;
  const found: (PaletteCommand | false | null)[] = [
    isFree &&
      connection.value !== null &&
      !editor.blocked.value && {
        name: program.write({ count: editor.changes.value.length }),
        run: () => void write.open(),
      },
    ...saveCommands(session, saveSetting),
    isFree &&
      undo && { name: edits.undo({ step: stepText(identity, undo) }), keys: ctrl('Z'), run: () => editor.undo() },
    isFree &&
      redo && { name: edits.redo({ step: stepText(identity, redo) }), keys: ctrl('Y'), run: () => editor.redo() },
    isFree && {
      name: words.print,
      // Elsewhere the key prints what is shown there.
      keys: views.shown.value === 'program' ? ctrl('P') : undefined,
      run: () => {
        printOrder.choose();
        views.show('print');
      },
    },
    session.opened.savable.value && { name: words.share, run: () => offerScreen(session, sharing) },
  ];
  return found.filter((command): command is PaletteCommand => Boolean(command));
}

function saveCommands(session: Session, saveSetting: SaveSetting): PaletteCommand[] {
  const { save } = moreMessages.value.library;
  const { unsaved, undoable } = session.opened;
  const { setting, model } = session.origin;
  const name = setting.value?.name;
  const undo = undoable.value;
  const differs = (unsaved.value?.changes ?? 0) + (unsaved.value?.unreadable ?? 0) > 0;
  return [
    ...(name !== undefined && differs
      ? [{ name: save.over({ program: programOf(name, model.value?.name ?? '') }), run: () => void saveSetting.save() }]
      : []),
    ...(undo ? [{ name: save.undo({ name: undo.name }), run: () => session.opened.undoSave() }] : []),
    { name: name === undefined ? save.open : save.asNew, run: () => saveSetting.open() },
  ];
}

function timerCommands({ session, leaving }: AppModels): PaletteCommand[] {
  const { header, program } = messages.value;
  const { editor, runner, link, connection, engaged } = session;
  if (runner.busy.value) return [{ name: header.stop, run: () => void runner.stop() }];
  if (connection.value) {
    return [
      { name: program.read, run: () => void readShown(session) },
      { name: header.disconnect, run: () => void leaving.disconnect() },
    ];
  }
  if (engaged.value) return [];
  return [
    ...(link.unavailable ? [] : [{ name: header.connect, run: () => void session.timer.connect() }]),
    ...(editor.identity.value ? [{ name: header.closeProgram, run: () => session.onScreen.closeProgram() }] : []),
  ];
}

/** Commands for the library, its files and its flights. */
function libraryCommands(models: AppModels): PaletteCommand[] {
  const { views, session, flights, sharing } = models;
  const { models: kept, settings } = session.library;
  const isEmpty = kept.list.value.length + settings.list.value.length === 0;
  const flying = (): void => {
    const key = flights.flying();
    if (key !== null) flights.fillIn(key);
  };
  return [
    ...(flights.flyable.value && !session.onScreen.apart.value
      ? [{ name: moreMessages.value.flights.flying.button, run: flying }]
      : []),
    { name: moreMessages.value.compare.open, run: () => views.show('library', COMPARE) },
    { name: moreMessages.value.files.import.button, run: () => filesOf(models).choose() },
    // Nobody may have looked yet at what is kept.
    ...(isEmpty && kept.loaded.value
      ? []
      : [{ name: moreMessages.value.files.export.all, run: () => void filesOf(models).export() }]),
    { name: moreMessages.value.share.paste.title, run: () => sharing.paste() },
  ];
}

function viewCommands({ views }: AppModels): PaletteCommand[] {
  const { names } = messages.value.views;
  return [
    ...VIEWS.filter((view) => view !== views.shown.value).map((view) => ({
      name: names[view],
      run: () => views.show(view),
    })),
    { name: moreMessages.value.flights.title, run: () => views.show('library', FLIGHTS) },
    { name: names.help, keys: '?', run: () => views.show('help') },
  ];
}
