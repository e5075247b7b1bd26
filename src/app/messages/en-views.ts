/** The views of the page and the links between them. */
export const views = {
  title: 'Views',
  names: {
    program: 'Program',
    memories: 'Memories',
    bench: 'Bench',
    library: 'Library',
    line: 'Line',
    settings: 'Settings',
    print: 'Print',
    help: 'Help',
  },
  /** The title of the window: “Memories · Sidus Timer”. */
  window: (view: string, name: string) => `${view} · ${name}`,
  print: 'Print…',
  share: 'Share…',
  noTimer: {
    memories: 'Connect a timer to see its memories. Backups are below.',
    bench: 'Connect a timer to move its servos.',
  },
};

/** The strip above every view: the timer, its memory, DT, motor stop, and what is known. */
export const strip = {
  close: 'Close the large figures',
  panel: 'Large figures',
  shortChanges: (count: number) => String(count),
  /** Positions that were tried while the servos follow: they are in the timer. */
  tried: (count: number) => `${count} tried`,
  /** In place of a figure. */
  notValid: 'not valid',
  asInTimer: '✓',
  notCertain: 'not certain',
  asRead: 'last read',
  /** For a setting of the library. */
  ofSetting: (changes: number) => (changes === 0 ? 'saved' : `${changes} not saved`),
  /** For a program that was made here and is in no timer. */
  made: 'in no timer',
};

/** Every action by its name. */
export const palette = {
  title: 'Commands',
  search: 'Type what you want to do',
  nothing: 'No command has this name, or it cannot be done now.',
  shift: (rows: string) => `Shift: ${rows}`,
  preset: (time: string) => `DT ${time}`,
  moveTo: (slot: string) => `Move the servos: ${slot}`,
  disconnect: (timer: string) => `Disconnect the ${timer}`,
  print: 'Print this program…',
  share: 'Share this program…',
  compare: 'Compare two programs…',
  import: 'Import a file into the library…',
  export: 'Export all of the library…',
  help: 'Help',
  helpOn: (page: string) => `Help: ${page}`,
  goTo: (view: string) => `Go to ${view}`,
  theme: (name: string) => `Colours: ${name}`,
};

/** In place of a part of the page that is being loaded. */
export const parts = {
  coming: 'Loading',
  failed: 'This part of the page could not be loaded.',
  /** Without them nothing opens that a click, a file or a link asks for. */
  dialogsFailed:
    'The dialogs of this page could not be loaded. Without them you cannot write to a timer, import a file, or see the setting in a link.',
  again: 'Try again',
};
