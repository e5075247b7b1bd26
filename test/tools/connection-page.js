// Makes the page help/connection.html from docs/connection.md, beside the built page: the steps for every system are
// read once, at home, so they are a text and no part of the program.

import { readFileSync } from 'node:fs';

/** Its address, relative to the page. src/app/connect/connection-help-view.tsx links to it. */
export const CONNECTION_PAGE = 'help/connection.html';
const SOURCE = new URL('../../docs/connection.md', import.meta.url);

/** @returns {import('vite').Plugin} */
export function connectionPage() {
  return {
    name: 'connection-page',
    apply: 'build',
    generateBundle() {
      this.emitFile({
        type: 'asset',
        fileName: CONNECTION_PAGE,
        source: connectionHtml(readFileSync(SOURCE, 'utf8')),
      });
    },
  };
}

/**
 * @param {string} text with the few forms that docs/connection.md has: headings, paragraphs, and lists whose items
 * continue with two spaces and end in lines to copy, indented by six.
 * @returns {string} a whole page
 * @throws when a part has another form
 */
export function connectionHtml(text) {
  const [title = ''] = /(?<=^# ).*/m.exec(text) ?? [];
  const parts = text.trim().split(/\n{2,}(?! )/);
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark">
<title>${escaped(title)}</title>
<style>body { max-width: 46rem; margin: 1rem auto; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif }
li { margin: .5rem 0 } pre { overflow-x: auto; padding: .5rem; border: 1px solid } code { font-size: 1rem }</style>
</head>
<body>
${parts.map(partOf).join('\n').replaceAll('</ul>\n<ul>\n', '')}
</body>
</html>
`;
}

/** @param {string} part between two empty lines */
function partOf(part) {
  const [, level, heading] = /^(##?) (.*)$/.exec(part) ?? [];
  if (level && heading) return `<h${level.length}>${inline(heading)}</h${level.length}>`;
  if (part.startsWith('- ')) return `<ul>\n${part.split(/^- /m).slice(1).map(itemOf).join('\n')}\n</ul>`;
  if (/^[#>|*`\s]/.test(part)) throw new Error(`docs/connection.md has a form that its page does not know: ${part}`);
  return `<p>${inline(part)}</p>`;
}

/** @param {string} item without its dash */
function itemOf(item) {
  const lines = item.trimEnd().split('\n');
  const first = lines.findIndex((line) => line.startsWith('      '));
  const said = first < 0 ? lines : lines.slice(0, first);
  const copy = first < 0 ? [] : lines.slice(first).map((line) => line.slice(6));
  const pre = copy.length > 0 ? `\n<pre><code>${escaped(copy.join('\n'))}</code></pre>` : '';
  return `<li>${inline(
    said
      .map((line) => line.trim())
      .join(' ')
      .trim(),
  )}${pre}</li>`;
}

/** @param {string} text */
function inline(text) {
  return escaped(text.replaceAll('\n', ' ')).replace(/`([^`]+)`/g, '<code>$1</code>');
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
