// What is new for a pilot, from the changelog: the build gives it to the page, and to the worker of a version that
// waits to be used.

/** How many releases the page shows. More would be too long to read. */
const RELEASES = 3;

/**
 * @typedef {object} Release
 * @property {string} version `0.2.0`
 * @property {{ title: string, items: string[] }[]} changes by their subject
 */

/**
 * @param {string} changelog in the form of Keep a Changelog
 * @param {string} version of this build, used for changes that are not released yet
 * @returns {Release[]} the newest first, without what concerns only programmers
 */
export function newsOf(changelog, version) {
  const sections = changelog.split(/^## /m).slice(1, 1 + RELEASES);
  return sections.map((section) => {
    const [, name = ''] = /^\[?([^\]\s]+)/.exec(section) ?? [];
    return { version: name === 'Unreleased' ? version : name, changes: changesIn(section) };
  });
}

/** @param {string} section @returns {Release['changes']} */
function changesIn(section) {
  /** @type {Release['changes']} */
  const changes = [];
  let heading = '';
  let title = '';
  let isForPilots = true;
  for (const block of section.split(/\n\s*\n/).map((each) => each.trim())) {
    if (block.startsWith('### ')) {
      heading = block.slice(4);
      title = heading;
      isForPilots = true;
    } else if (/^[^-|].*:$/s.test(block)) {
      // A line with the subject of the list below it.
      const about = plain(block).slice(0, -1);
      isForPilots = !about.startsWith('The package');
      title = about === 'The page' ? heading : about;
    } else if (block.startsWith('- ') && isForPilots) {
      const items = block.split(/\n(?=- )/).map((item) => plain(item.slice(2)));
      const before = changes.find((each) => each.title === title);
      if (before) before.items.push(...items);
      else changes.push({ title, items });
    }
  }
  return changes;
}

/** Without markup, on one line. @param {string} text */
function plain(text) {
  return text
    .replace(/\[([^\]]+)\]\([^)]*\)/g, '$1')
    .replace(/\*\*|`/g, '')
    .replace(/\s+/g, ' ')
    .trim();
}
