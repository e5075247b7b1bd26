import { fieldKey } from '../program/index.js';
import type { Identity } from '../protocol/index.js';
import { COMPARE } from './compare/address.js';
import { setValues } from './editing/edit.js';
import { FLIGHTS } from './flights/flight-filter.js';
import { HELP_PAGES } from './help/help.js';
import type { SaveSetting } from './library/save-setting.js';
import { offerScreen } from './library/share/share-screen.js';
import { filesOf } from './library-files.js';
import { flightMessages } from './messages/en-flights.js';
import { guide } from './messages/en-guide.js';
import { libraryMessages } from './messages/en-library.js';
import { share } from './messages/en-share.js';
import { messages, presetText, slotLabel, stepText, timerName } from './messages/index.js';
import type { AppModels } from './models.js';
import type { Session } from './session/session.js';
import { SIMULATED_CLASSES } from './session/timer-access.js';
import { THEMES } from './settings/theme.js';
import type { PaletteCommand } from './shell/palette.js';
import { VIEWS } from './shell/views.js';

/** All commands that are possible now, the most wanted first. */
export function commandsOf(models: AppModels): readonly PaletteCommand[] {
  return [
    ...programCommands(models),
    ...timerCommands(models),
    ...flightCommands(models),
    ...libraryCommands(models),
    ...pageCommands(models),
  ];
}

function programCommands(models: AppModels): PaletteCommand[] {
  const { session, write, preferences, bench, memories, views, programPicture, printOrder, saveSetting, sharing } =
    models;
  const { editor, runner, connection } = session;
  const { palette, program, edits, slotName } = messages.value;
  const identity = editor.identity.value;
  if (!identity || write.current.value) return [];
  const isFree = !runner.busy.value;
  const dt = { kind: 'time', slot: identity.functions } as const;
  const { value: undo } = editor.undoStep;
  const { value: redo } = editor.redoStep;
  const found: (PaletteCommand | false | null)[] = [
    isFree &&
      connection.value !== null &&
      !editor.blocked.value && { name: program.write(editor.changes.value.length), run: () => void write.open() },
    ...saveCommands(session, saveSetting),
    isFree && undo && { name: edits.undo(stepText(identity, undo)), keys: 'Ctrl+Z', run: () => editor.undo() },
    isFree && redo && { name: edits.redo(stepText(identity, redo)), keys: 'Ctrl+Y', run: () => editor.redo() },
    isFree && editor.dirty.value && { name: program.undoAll, run: () => editor.revertAll() },
    isFree && {
      name: palette.print,
      // Elsewhere the key prints what is shown there.
      keys: views.shown.value === 'program' ? 'Ctrl+P' : undefined,
      run: () => {
        printOrder.choose();
        views.show('print');
      },
    },
    session.opened.savable.value && { name: palette.share, run: () => offerScreen(session, sharing) },
    ...(memories.looking.value === null ? shiftable(identity) : []).map((slot) => ({
      name: palette.shift(
        edits.shift.from(slot === 0 ? program.motorStop : slotLabel(identity, slot), slot === dt.slot),
      ),
      run: () => {
        views.show('program');
        programPicture.askShift(slot);
      },
    })),
    ...preferences.presets.value.map((value) => ({
      name: palette.preset(presetText(value)),
      run: () => editor.apply(setValues({ code: 'change', params: { field: fieldKey(dt) } }, [{ field: dt, value }])),
    })),
    ...(bench.ready.value
      ? Array.from({ length: identity.functions + 1 }, (_, slot) => ({
          name: palette.moveTo(slotName(slot, slot === 0 ? 'start' : slot === identity.functions ? 'dt' : 'function')),
          run: () => void bench.moveTo(slot),
        }))
      : []),
  ];
  return found.filter((command): command is PaletteCommand => Boolean(command));
}

function saveCommands(session: Session, saveSetting: SaveSetting): PaletteCommand[] {
  const { save } = libraryMessages;
  const { unsaved, undoable } = session.opened;
  const { setting, model } = session.origin;
  const name = setting.value?.name;
  const undo = undoable.value;
  const differs = (unsaved.value?.changes ?? 0) + (unsaved.value?.unreadable ?? 0) > 0;
  return [
    ...(name !== undefined && differs
      ? [{ name: save.over(name, model.value?.name ?? ''), run: () => void saveSetting.save() }]
      : []),
    ...(undo ? [{ name: save.undo(undo.name), run: () => session.opened.undoSave() }] : []),
    { name: name === undefined ? save.open : save.asNew, run: () => saveSetting.open() },
  ];
}

function flightCommands({ views, flights }: AppModels): PaletteCommand[] {
  const words = flightMessages;
  const flying = (): void => {
    const key = flights.flying();
    if (key !== null) flights.fillIn(key);
  };
  return [
    ...(flights.flyable.value ? [{ name: words.flying.button, run: flying }] : []),
    { name: messages.value.palette.goTo(words.title), run: () => views.show('library', FLIGHTS) },
  ];
}

/** The slots whose time, and all later ones, can be shifted. 0 is the motor stop. */
function shiftable(identity: Identity): number[] {
  const slots = Array.from({ length: identity.functions + 1 }, (_, slot) => slot);
  return slots.filter((slot) => slot > 0 || identity.timerClass === 'Q');
}

function timerCommands({ session, memories, leaving }: AppModels): PaletteCommand[] {
  const { palette, header, program, look, memories: words, overview, memoryName } = messages.value;
  const { editor, runner, link, connection, engaged, nextFlight } = session;
  const baseline = editor.baseline.value;
  const current = baseline?.memory ?? null;
  if (runner.busy.value) return [{ name: header.stop, run: () => void runner.stop() }];
  if (!connection.value) {
    if (engaged.value) return [];
    return [
      ...(link.unavailable ? [] : [{ name: header.connect, run: () => void session.timer.connect() }]),
      ...(editor.identity.value ? [{ name: header.closeProgram, run: () => session.onScreen.closeProgram() }] : []),
      ...SIMULATED_CLASSES.map((timerClass) => ({
        name: messages.value.start.simulated(messages.value.classNames[timerClass] ?? timerClass),
        run: () => void session.timer.trySimulated(timerClass),
      })),
    ];
  }
  const others = Array.from({ length: baseline?.identity.memories ?? 0 }, (_, memory) => memory).filter(
    (memory) => memory !== current,
  );
  return [
    { name: program.read, run: () => void session.reader.read() },
    ...(current === null ? [] : [{ name: overview.readAll, run: () => void memories.jobs.open({ kind: 'back-up' }) }]),
    ...others.flatMap((memory) => [
      { name: look.look(memoryName(memory)), run: () => void memories.look(memory) },
      { name: look.fly(memoryName(memory)), run: () => void memories.fly(memory) },
    ]),
    ...(current === null || nextFlight.open.value
      ? []
      : others.map((to) => ({
          name: words.copy(memoryName(current), memoryName(to)),
          run: () => void memories.jobs.open({ kind: 'copy', from: current, to }),
        }))),
    { name: palette.disconnect(timerName(connection.value.identity)), run: () => void leaving.disconnect() },
  ];
}

/** Commands for the files of the library, and for its other places. */
function libraryCommands(models: AppModels): PaletteCommand[] {
  const { palette } = messages.value;
  const { views, session } = models;
  const { models: kept, settings } = session.library;
  const isEmpty = kept.list.value.length + settings.list.value.length === 0;
  return [
    { name: palette.compare, run: () => views.show('library', COMPARE) },
    { name: palette.import, run: () => filesOf(models).ask() },
    // Nobody may have looked yet at what is kept.
    ...(isEmpty && kept.loaded.value ? [] : [{ name: palette.export, run: () => void filesOf(models).exportAll() }]),
  ];
}

function pageCommands({ views, theme, erase, sharing }: AppModels): PaletteCommand[] {
  const { palette, views: words, theme: themes, erase: eraseWords } = messages.value;
  return [
    ...VIEWS.filter((view) => view !== views.shown.value).map((view) => ({
      name: palette.goTo(words.names[view]),
      run: () => views.show(view),
    })),
    { name: palette.help, keys: '?', run: () => views.show('help') },
    ...HELP_PAGES.map((page) => ({ name: palette.helpOn(guide.pages[page]), run: () => views.show('help', page) })),
    ...THEMES.filter((name) => name !== theme.chosen.value).map((name) => ({
      name: palette.theme(themes.names[name]),
      run: () => theme.choose(name),
    })),
    { name: share.paste.title, run: () => sharing.paste() },
    { name: eraseWords.open, run: () => erase.open() },
  ];
}
