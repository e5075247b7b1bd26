import { whole } from './dotted.js';
import { obstacles } from './en-library.js';
import { plural } from './plural.js';

/** A setting as a link and a QR code, and back. Only these dialogs need these sentences. */
export const share = {
  offer: {
    title: (name: string) => `Share “${name}”`,
    lead: 'The link holds the whole setting. Nothing is sent to a server: whoever has the link has the values.',
    link: 'Link',
    copy: 'Copy link',
    send: 'Share…',
    sendFailed: 'The browser could not share it. Copy the link instead.',
    scan: 'Point the camera of the other device at this code, or send the link.',
    qr: (name: string) => `QR code of “${name}”`,
    cut: 'The end of the note does not fit in the QR code. The link holds the whole note.',
    tooLong: 'This setting is too long for a QR code. Send the link.',
  },
  received: {
    title: 'A setting from a link',
    from: (model: string) => `of ${model}`,
    lead: 'So far this page only shows it. Nothing is kept, and nothing is written to a timer.',
    dated: (date: string) => `Last changed ${date}`,
    timer: (timer: string, firmware: string, functions: number, servos: number) =>
      `${timer}, ${firmware === '000' ? '' : `firmware\u00a0${firmware}, `}${whole(plural(functions, 'function', 'functions'))}, ${whole(plural(servos, 'servo', 'servos'))}`,
    tags: (tags: readonly string[]) => `Tags: ${tags.join(', ')}`,
    known: (name: string) => `The library has these values already: ${name}.`,
    modelChoice: 'Keep it under',
    newModel: (name: string) => `New model “${name}”`,
    noModel: 'No model',
    keep: 'Keep in the library',
    open: 'Open',
    openOver: 'Load into the table',
    discard: 'Do not keep',
    /** What happens to unwritten edits. @param over whether the setting replaces what the connected timer holds. */
    unwritten: (over: boolean) =>
      over
        ? 'What you have typed stays: Undo brings it back.'
        : 'The program on the screen is closed. What you have typed is kept on this device.',
    notOpened: 'It could not be opened just now. Try again.',
    show: 'Show in the library',
    kept: (name: string) => `“${name}” is in the library.`,
    notKept: (name: string) =>
      `This browser could not keep “${name}”: it is lost when the page is closed. Keep the link.`,
    obstacles,
  },
  damaged: {
    title: 'This link cannot be read.',
    codes: {
      'bad-link': 'It is cut or damaged: a part was lost on the way. Ask for the link again, or for its QR code.',
      'newer-version': 'A newer version of this page made it. Load the page again while you are online.',
      'too-large': 'It is longer than any setting. It did not come from this page.',
      other: 'It has values that no timer can hold. It did not come from this page, or it was changed on the way.',
    },
  },
  paste: {
    title: 'Paste a link…',
    lead: 'The camera of a phone opens a QR code by itself. Here you can paste a link.',
    show: 'Show',
    notLink: 'This is not a link to a program.',
  },
};
