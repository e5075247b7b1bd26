// Draws the rooms of src/ and the imports between them into docs/rooms.svg and docs/page.svg (the folders of the page). Run it when a test
// says that a picture is old: node test/tools/rooms.js

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = new URL('../../', import.meta.url);

/** @typedef {Map<string, Map<string, number>>} Graph from a room to the rooms it imports, with the number of imports */

/**
 * The imports between the folders of a folder. Files that lie in it directly are a room called by the folder's own name.
 * @param {string} folder from the root of the project, such as `src`.
 * @returns {Graph}
 */
export function importsBetween(folder) {
  const base = fileURLToPath(new URL(`${folder}/`, root));
  const own = folder.split('/').at(-1) ?? folder;
  /** @type {(file: string) => string} */
  const roomOf = (file) => (file.includes('/') ? /** @type {string} */ (file.split('/')[0]) : own);
  /** @type {Graph} */
  const graph = new Map();
  const files = readdirSync(base, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
  for (const file of files.sort()) {
    const room = roomOf(file);
    const uses = graph.get(room) ?? new Map();
    graph.set(room, uses);
    const text = readFileSync(new URL(`${folder}/${file}`, root), 'utf8');
    for (const [, path = ''] of text.matchAll(/(?:from|import\()\s*'(\.[^']+)\.js'/g)) {
      const target = new URL(path, `file:///${file}`).pathname.slice(1);
      const other = path.startsWith('.') && new URL(path, `file:///x/${file}`).pathname.startsWith('/x/');
      if (other && roomOf(target) !== room) uses.set(roomOf(target), (uses.get(roomOf(target)) ?? 0) + 1);
    }
  }
  return graph;
}

/**
 * How many rooms lie below each, one under the other at most.
 * @param {Graph} graph
 * @throws Error when imports go round.
 */
export function levels(graph) {
  /** @type {Map<string, number>} */
  const found = new Map();
  /** @type {(room: string, above: readonly string[]) => number} */
  const levelOf = (room, above) => {
    if (above.includes(room)) throw new Error(`imports go round: ${[...above, room].join(' -> ')}`);
    const known = found.get(room);
    if (known !== undefined) return known;
    const below = [...(graph.get(room)?.keys() ?? [])].map((used) => levelOf(used, [...above, room]));
    const level = Math.max(-1, ...below) + 1;
    found.set(room, level);
    return level;
  };
  for (const room of graph.keys()) levelOf(room, []);
  return found;
}

/**
 * A picture of it: arrows go down to what is used. Where a longer way leads to the same room, the short one is left out.
 * @param {Graph} graph
 * @param {string} title
 */
export function draw(graph, title) {
  const level = levels(graph);
  const top = Math.max(...level.values());
  const rows = Array.from({ length: top + 1 }, (_, index) =>
    [...graph.keys()].filter((room) => level.get(room) === top - index).sort(),
  );
  const [boxWidth, boxHeight, rowHeight] = [132, 34, 84];
  const width = Math.max(...rows.map((row) => row.length)) * (boxWidth + 40) + 40;
  const height = rows.length * rowHeight + 20;
  /** @type {Map<string, { x: number, y: number }>} */
  const places = new Map();
  rows.forEach((row, index) => {
    row.forEach((room, place) => {
      places.set(room, { x: Math.round((width * (place + 1)) / (row.length + 1)), y: 36 + index * rowHeight });
    });
  });
  /** @type {(from: string, to: string) => boolean} */
  const reaches = (from, to) => [...(graph.get(from)?.keys() ?? [])].some((next) => next === to || reaches(next, to));
  const at = (/** @type {string} */ room) => /** @type {{ x: number, y: number }} */ (places.get(room));
  const arrows = [...graph].flatMap(([room, uses]) =>
    [...uses]
      .filter(([used]) => ![...uses.keys()].some((next) => next !== used && reaches(next, used)))
      .map(([used]) => {
        const [from, to] = [at(room), at(used)];
        const [begin, end] = [from.y + boxHeight / 2, to.y - boxHeight / 2 - 3];
        // Sideways first, then down beside the rooms between.
        const bend = `C${to.x} ${begin + 26} ${to.x} ${begin + 26} ${to.x} ${end}`;
        const path = `<path d="M${from.x} ${begin}${from.x === to.x ? `V${end}` : bend}" marker-end="url(#head)"/>`;
        return `<g class="arrow"><title>${room} imports ${used}</title>${path}</g>`;
      }),
  );
  const boxes = [...places].map(
    ([room, { x, y }]) =>
      `<rect x="${x - boxWidth / 2}" y="${y - boxHeight / 2}" width="${boxWidth}" height="${boxHeight}" rx="6"/>` +
      `<text x="${x}" y="${y + 5}">${room}</text>`,
  );
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" aria-label="${title}">
<style>
rect { fill: #fff; stroke: #1b2733; stroke-width: 1.5 }
text { font: 15px system-ui, sans-serif; text-anchor: middle; fill: #1b2733 }
.arrow path { fill: none; stroke: #1b2733; stroke-width: 1.5 }
</style>
<marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto"><path d="M0 0 8 4 0 8z"/></marker>
<rect width="${width}" height="${height}" style="stroke: none"/>
${arrows.join('\n')}
${boxes.join('\n')}
</svg>
`;
}

/** The pictures, by file. */
export const pictures = {
  'docs/rooms.svg': () => draw(withoutOwn(importsBetween('src'), 'src'), 'The rooms of src and what each imports'),
};

/** @param {Graph} graph @param {string} own */
function withoutOwn(graph, own) {
  return new Map([...graph].filter(([room]) => room !== own));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [file, picture] of Object.entries(pictures)) writeFileSync(new URL(file, root), picture());
}
