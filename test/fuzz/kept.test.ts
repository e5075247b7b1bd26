import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import * as program from '../../src/program/index.js';
import * as protocol from '../../src/protocol/index.js';
import { fuzz } from './fuzz.js';
import { KEPT_LAWS, type Keeping } from './kept-laws.js';

const keeping = { ...protocol, ...program };

describe('files and links', () => {
  it('keep their laws in a few hundred cases', () => {
    expect(fuzz(keeping, { seed: 20261122, cases: 60, more: (round) => round < 1, laws: KEPT_LAWS })).toEqual({
      cases: 60 * Object.keys(KEPT_LAWS).length,
      failure: null,
    });
  });
});

const { parseLibraryFile, formatLibraryFile, decodeLink, encodeLink } = program;

describe('each law notices what breaks it', () => {
  const faults: [law: string, broken: Partial<Keeping>][] = [
    ['file: a library', { formatLibraryFile: (of, head) => formatLibraryFile(of, { ...head, facts: new Map() }) }],
    [
      'file: a text',
      {
        parseLibraryFile: (text) => {
          JSON.parse(text);
          return parseLibraryFile(text);
        },
      },
    ],
    [
      'file: values',
      {
        parseLibraryFile: (text) =>
          parseLibraryFile(text.replace(/"functions":126/, '"functions":125').replace(/:1\.5/g, ':1')),
      },
    ],
    [
      'file: any other',
      {
        parseLibraryFile: (text) =>
          parseLibraryFile(
            /^\[+$/.test(text)
              ? formatLibraryFile({ models: [], settings: [], flights: [] }, { writtenAt: 0, writtenBy: '' })
              : text,
          ),
      },
    ],
    ['link: a setting', { encodeLink: (of, options) => encodeLink({ ...of, note: of.note.trim() }, options) }],
    [
      'link: one that was damaged',
      {
        decodeLink: (link) => {
          try {
            return decodeLink(link);
          } catch {
            return decodeLink('AVEYAgIEAgMBDOgDHgBQRg8ZcxQeeIC82fKeNARjYWxtCUxhbmNlciAwNwABB2ZseS1vZmawiUWF');
          }
        },
      },
    ],
    ['link: one that was made', { decodeLink: (link) => ({ ...decodeLink(link), tags: [] }) }],
    [
      'link: any other',
      {
        decodeLink: (link) => {
          if (link.startsWith('{')) throw new Error('no link');
          return decodeLink(link);
        },
      },
    ],
  ];

  it.each(faults)('%s', (law, broken) => {
    const [[, property] = []] = Object.entries(KEPT_LAWS).filter(([name]) => name.startsWith(law));
    expect(
      property && fc.check(property({ ...keeping, ...broken }), { seed: 1, numRuns: 3000, endOnFailure: true }),
    ).toMatchObject({ failed: true });
  });

  it('all of them', () => expect(faults).toHaveLength(Object.keys(KEPT_LAWS).length));
});
