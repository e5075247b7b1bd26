/** A saved program as a link and a QR code, and back. Only these dialogs need these sentences. */
export const share = {
  offer: {
    lead: 'The link holds the whole program. Nothing is sent to a server.',
    link: 'Link',
    copy: 'Copy link',
    scan: 'Point the camera of the other device at this code, or send the link.',
    qr: (name: string) => `QR code of “${name}”`,
    cut: 'The end of the note does not fit in the QR code. The link holds the whole note.',
    tooLong: 'Too long for a QR code. Send the link.',
  },
  received: {
    title: 'A program from a link',
    lead: 'So far this page only shows it. Nothing is kept, and nothing is written to a timer.',
    known: (name: string) => `The library has these values already: ${name}.`,
    modelChoice: 'Keep it under',
    newModel: (name: string) => `New model “${name}”`,
    keep: 'Keep in the library',
    discard: 'Do not keep',
    unwritten: 'What you have typed is kept: Undo, or the start, brings it back.',
  },
  damaged: {
    title: 'This link cannot be read.',
    bad: 'It is cut or damaged, or not from this page. Ask for it again.',
  },
  paste: {
    title: 'Paste a link…',
    lead: 'The camera of a phone opens a QR code by itself. Here you can paste a link.',
    show: 'Show',
    notLink: 'This is not a link to a program.',
  },
};
