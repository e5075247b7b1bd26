// Draws what imports what: the rooms of src/ into docs/rooms.svg, the folders of the page into docs/page.svg. Run it
// when a test says that a picture is old: node test/tools/rooms.js

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = new URL('../../', import.meta.url);

/** @typedef {Map<string, Map<string, number>>} Graph from a room to the rooms it imports, with the number of imports */

/**
 * The imports between the folders of a folder. Files that lie in it directly are a room called by the folder's own
 * name.
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
 * The length of the longest chain of rooms below each room.
 * @param {Graph} graph
 * @throws Error when imports form a circle.
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
 * @typedef {{ room: string | null, above: Place[], x: number, y: number }} Place a room in a row, or a gap (null) for
 * an arrow that passes
 */

/**
 * The arrows. An arrow is left out where other arrows lead to the same room.
 * @param {Graph} graph
 * @returns {[from: string, to: string][]}
 */
function arrowsOf(graph) {
  /** @type {(from: string, to: string) => boolean} */
  const reaches = (from, to) => [...(graph.get(from)?.keys() ?? [])].some((next) => next === to || reaches(next, to));
  return [...graph].flatMap(([room, uses]) =>
    [...uses.keys()]
      .filter((used) => ![...uses.keys()].some((next) => next !== used && reaches(next, used)))
      .map((used) => /** @type {[string, string]} */ ([room, used])),
  );
}

const [BOX_WIDTH, BOX_HEIGHT, ROW_HEIGHT, GAP, PASS_WIDTH] = [116, 34, 76, 20, 12];

/** @param {Place} place */
const widthOf = ({ room }) => (room === null ? PASS_WIDTH : BOX_WIDTH);

/**
 * The rooms in rows, each below all that use it. An arrow over several rows has its own gap in each row, so that it
 * passes behind no room.
 * @param {Graph} graph
 * @returns {Place[][]}
 */
function placed(graph) {
  const level = levels(graph);
  const top = Math.max(...level.values());
  const rowOf = (/** @type {string} */ room) => top - (level.get(room) ?? 0);
  /** @type {Place[][]} */
  const rows = Array.from({ length: top + 1 }, () => []);
  /** @type {(row: number, room: string | null) => Place} */
  const add = (row, room) => {
    const place = { room, above: [], x: 0, y: row * ROW_HEIGHT + BOX_HEIGHT };
    rows[row]?.push(place);
    return place;
  };
  const places = new Map([...graph.keys()].sort().map((room) => [room, add(rowOf(room), room)]));
  for (const [from, to] of arrowsOf(graph)) {
    let last = /** @type {Place} */ (places.get(from));
    for (let row = rowOf(from) + 1; row < rowOf(to); row++) {
      const pass = add(row, null);
      pass.above.push(last);
      last = pass;
    }
    places.get(to)?.above.push(last);
  }
  const widths = rows.map((row) => row.reduce((sum, place) => sum + widthOf(place) + GAP, GAP));
  const width = Math.max(...widths);
  // Each room moves below its users: a few rounds, down and up, until little changes.
  const mean = (/** @type {Place[]} */ near, /** @type {number} */ own) =>
    near.length === 0 ? own : near.reduce((sum, { x }) => sum + x, 0) / near.length;
  const spread = (/** @type {Place[]} */ row) => {
    let x = (width - row.reduce((sum, place) => sum + widthOf(place) + GAP, -GAP)) / 2;
    for (const place of row) {
      place.x = Math.round(x + widthOf(place) / 2);
      x += widthOf(place) + GAP;
    }
  };
  rows.forEach(spread);
  for (let round = 0; round < 12; round++) {
    const down = round % 2 === 0;
    for (const row of down ? rows : [...rows].reverse()) {
      const below = (/** @type {Place} */ place) => rows.flat().filter(({ above }) => above.includes(place));
      const wanted = new Map(row.map((place) => [place, mean(down ? place.above : below(place), place.x)]));
      row.sort((a, b) => (wanted.get(a) ?? 0) - (wanted.get(b) ?? 0));
      spread(row);
    }
  }
  return rows;
}

/**
 * Draws the graph: arrows go down to the rooms that are used.
 * @param {Graph} graph
 * @param {string} title
 */
export function draw(graph, title) {
  const rows = placed(graph);
  const places = rows.flat();
  const half = BOX_HEIGHT / 2;
  const width = Math.max(...places.map((place) => place.x + widthOf(place) / 2)) + GAP;
  const arrows = places
    .flatMap((place) => place.above.map((from) => ({ from, place })))
    .map(({ from, place }) => {
      const [begin, end] = [from.y + half, place.y - half - (place.room === null ? 0 : 3)];
      const middle = (begin + end) / 2;
      const bend = `M${from.x} ${begin}C${from.x} ${middle} ${place.x} ${middle} ${place.x} ${end}`;
      return place.room === null
        ? `<path d="${bend}V${place.y + half}"/>`
        : `<path d="${bend}" marker-end="url(#head)"/>`;
    });
  const boxes = places
    .filter(({ room }) => room !== null)
    .map(
      ({ room, x, y }) =>
        `<rect x="${x - BOX_WIDTH / 2}" y="${y - half}" width="${BOX_WIDTH}" height="${BOX_HEIGHT}" rx="6"/>` +
        `<text x="${x}" y="${y + 5}">${room}</text>`,
    );
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${rows.length * ROW_HEIGHT}" role="img" aria-label="${title}">
<style>
rect { fill: #fff; stroke: #1b2733; stroke-width: 1.5 }
text { font: 15px system-ui, sans-serif; text-anchor: middle; fill: #1b2733 }
path { fill: none; stroke: #1b2733; stroke-width: 1.5 }
marker path { fill: #1b2733; stroke: none }
</style>
<marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto"><path d="M0 0 8 4 0 8z"/></marker>
<rect width="100%" height="100%" style="stroke: none"/>
${arrows.join('\n')}
${boxes.join('\n')}
</svg>
`;
}

/** The pictures, by file. */
export const pictures = {
  'docs/rooms.svg': () => draw(withoutOwn(importsBetween('src'), 'src'), 'The rooms of src and what each imports'),
  'docs/page.svg': () => draw(importsBetween('src/app'), 'The folders of src/app and what each imports'),
};

/** @param {Graph} graph @param {string} own */
function withoutOwn(graph, own) {
  return new Map([...graph].filter(([room]) => room !== own));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [file, picture] of Object.entries(pictures)) writeFileSync(new URL(file, root), picture());
}
