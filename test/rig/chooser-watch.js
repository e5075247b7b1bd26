// Tells what Chromium's own port chooser shows, as a line of JSON whenever that changes: { shown, rows, selected }.
// Runs inside the box, as `node --experimental-websocket chooser-watch.js PORT`, and asks Chromium's UI DevTools, which
// know the browser's own windows as the usual DevTools know a page. It only looks.

import { setTimeout as sleep } from 'node:timers/promises';

/** @typedef {{ nodeId: number, attributes?: string[], children?: UiNode[] }} UiNode */
/** @typedef {{ rule: { style: { cssProperties: { name: string, value: string }[] } } }} RuleMatch */

/** @param {string} url @returns {Promise<WebSocket>} */
async function connect(url) {
  for (;;) {
    const socket = new WebSocket(url);
    const opened = await new Promise((resolve) => {
      socket.onopen = () => resolve(true);
      socket.onerror = () => resolve(false);
    });
    if (opened) return socket;
    await sleep(100); // Chromium has not started yet.
  }
}

const socket = await connect(`ws://127.0.0.1:${process.argv[2]}/0`);
socket.onclose = () => process.exit();
/** @type {Map<number, (result: any) => void>} */
const waiting = new Map();
socket.onmessage = ({ data }) => {
  const { id, result = {} } = JSON.parse(data);
  waiting.get(id)?.(result);
  waiting.delete(id);
};
let asked = 0;

/** @param {string} method @param {object} [params] @returns {Promise<any>} */
function ask(method, params = {}) {
  const id = ++asked;
  socket.send(JSON.stringify({ id, method, params }));
  return new Promise((resolve) => waiting.set(id, resolve));
}

/**
 * @param {UiNode | undefined} node @param {string} name @returns {UiNode | undefined} the first of this name, from the
 * node down
 */
function find(node, name) {
  if (!node || node.attributes?.[1] === name) return node;
  for (const child of node.children ?? []) {
    const found = find(child, name);
    if (found) return found;
  }
  return undefined;
}

/** @param {UiNode} node @returns {Promise<Map<string, string>>} */
async function propertiesOf({ nodeId }) {
  /** @type {{ matchedCSSRules?: RuleMatch[] }} */
  const { matchedCSSRules = [] } = await ask('CSS.getMatchedStylesForNode', { nodeId });
  const properties = matchedCSSRules.flatMap(({ rule }) => rule.style.cssProperties);
  return new Map(properties.map(({ name, value }) => [name, value]));
}

async function look() {
  // The tree is told afresh only to one who enables it again.
  await ask('DOM.disable');
  await ask('DOM.enable');
  const { root } = await ask('DOM.getDocument');
  const chooser = find(root, 'ChooserBubbleUiViewDelegate');
  const table = find(chooser, 'TableView');
  const properties = table ? await propertiesOf(table) : new Map();
  const isDrawn = properties.get('IsDrawn') === 'true';
  const selected = Number.parseInt(properties.get('FirstSelectedRow'), 10); // or '<Empty>'
  return {
    shown: chooser !== undefined,
    rows: isDrawn ? Number(properties.get('RowCount')) : 0,
    selected: Number.isNaN(selected) ? -1 : selected,
  };
}

await ask('DOM.enable');
await ask('CSS.enable');
let before = '';
for (;;) {
  const now = JSON.stringify(await look());
  if (now !== before) process.stdout.write(`${now}\n`);
  before = now;
  await sleep(50);
}
