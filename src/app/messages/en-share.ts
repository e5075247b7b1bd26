import { plural } from './plural.js';

/** A setting as a link and a QR code, and back. Only the dialogs of these need these sentences. */
export const share = {
  offer: {
    title: (name: string) => `Share “${name}”`,
    lead: 'The link holds the whole setting. Nothing is sent to a server: whoever has the link has the values.',
    link: 'Link',
    copy: 'Copy link',
    send: 'Share…',
    sendFailed: 'The browser could not share it. Copy the link instead.',
    scan: 'Point the camera of the other device at this code, or send the link below.',
    qr: (name: string) => `QR code of “${name}”`,
    cut: 'The end of the note has no room in the QR code. The link holds all of it.',
    tooLong: 'This setting is too long for a QR code. Send the link.',
    close: 'Close',
  },
  received: {
    title: 'A setting came by link',
    from: (model: string) => `of ${model}`,
    lead: 'It is only shown. Nothing is written to a timer, and nothing is kept until you say so.',
    dated: (date: string) => `Last changed ${date}`,
    timer: (timer: string, firmware: string, functions: number, servos: number) =>
      `${timer}, ${firmware === '000' ? '' : `firmware ${firmware}, `}${plural(functions, 'function', 'functions')}, ${plural(servos, 'servo', 'servos')}`,
    tags: (tags: readonly string[]) => `Tags: ${tags.join(', ')}`,
    known: (name: string) => `The library has these values already: ${name}.`,
    modelChoice: 'Keep it under',
    newModel: (name: string) => `New model “${name}”`,
    noModel: 'No model',
    keep: 'Keep in the library',
    open: 'Open in the editor',
    openOver: 'Load into the table',
    close: 'Close',
    discard: 'Do not keep',
    /** What becomes of what was typed. @param over it comes over what the timer at hand holds. */
    unwritten: (over: boolean) =>
      over
        ? 'What you have typed stays: Undo brings it back.'
        : 'The program on the screen is put away. What you have typed is kept on this device.',
    notOpened: 'It could not be opened just now. Try again.',
    show: 'Show in the library',
    kept: (name: string) => `“${name}” is in the library.`,
    notKept: (name: string) =>
      `This browser could not keep “${name}”: it is lost when the page is closed. Keep the link.`,
    obstacles: {
      busy: 'The timer is being read or written, or looked for. Wait until that has ended.',
      following: 'The servos follow what you edit. Stop that first.',
      'other-class': 'The timer that is connected is of another class. Disconnect it first.',
      'other-layout': 'The timer that is connected has other functions or servos. Disconnect it first.',
    },
  },
  damaged: {
    title: 'This link cannot be read.',
    codes: {
      'bad-link': 'It is cut or damaged: a part was lost on the way. Ask for the link again, or for its QR code.',
      'newer-version': 'A newer version of this page made it. Load the page again while you are online.',
      'too-large': 'It is longer than any setting. It did not come from this page.',
      other: 'It says what no timer can hold. It did not come from this page, or was changed on the way.',
    },
  },
  read: {
    title: 'Read a QR code',
    lead: 'Another device shows it under Share.',
    camera: 'Use the camera',
    stop: 'Stop the camera',
    starting: 'Asking for the camera',
    looking: 'Hold the QR code in the picture.',
    view: 'What the camera sees',
    image: 'Choose a picture…',
    imageLabel: 'Picture with a QR code',
    reading: 'Looking at the picture',
    paste: 'Or paste a link',
    show: 'Show',
    close: 'Close',
    faults: {
      denied:
        'The browser does not give the camera to this page. Allow it in the settings of the browser, or choose a picture.',
      none: 'No camera was found. Choose a picture of the QR code.',
      taken: 'Another program has the camera. Close that, or choose a picture.',
      missing: 'This browser gives no camera to pages. Choose a picture of the QR code.',
      failed: 'The camera could not be started. Choose a picture of the QR code.',
      picture: 'This file is no picture that the browser can read.',
      large: 'This picture is too large. Choose one of at most 64 million pixels and 50 MB.',
      nothing: 'No QR code was found in this picture. Take the picture from nearer, straight from the front.',
      reader: 'The part of the page that reads QR codes could not be loaded. Go online and try again.',
    },
    other: (text: string) => `This QR code holds no setting. It says: ${text}`,
    notLink: 'This is no link to a setting.',
  },
};
