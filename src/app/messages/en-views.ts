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
  print: 'Print…',
  share: 'Share…',
  noTimer: {
    memories: 'Connect a timer to see its memories. Backups are below.',
    bench: 'Connect a timer to move its servos.',
  },
};

/** The strip above every view: the timer, its memory, DT, motor stop, and what is known. */
export const strip = {
  panel: 'Memories and more',
  /** Positions that were tried while the servos follow: they are in the timer. */
  tried: (count: number) => `${count} tried`,
  notCertain: 'not certain',
  asRead: 'last read',
  /** In place of a figure. */
  notValid: 'not valid',
  /** For a program of the library. */
  ofSetting: (changes: number) => (changes === 0 ? 'saved' : `${changes} not saved`),
  /** For a program that was made here and is in no timer. */
  made: 'in no timer',
};

/** The list of commands. */
export const palette = {
  title: 'Commands',
  search: 'Type what you want to do',
  nothing: 'No command has this name, or it cannot be done now.',
};

/** In place of a part of the page that is being loaded. */
export const parts = {
  coming: 'Loading',
  failed: 'A part of this page could not be loaded.',
  again: 'Try again',
};
