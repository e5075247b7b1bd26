import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { newsOf } from './tools/news.js';
import { root } from './tools/pack.js';

const CHANGELOG = `# Changelog

What changes.

## [Unreleased]

Some words before.

### Changed

| was | is |
|---|---|
| \`a\` | \`b\` |

The package:

- A name of the package
  on two lines.

The page:

- **Write** is [quicker](docs/x.md),
  and \`2.5\` is read.
- Another.

### Added

Connect:

- A bridge.

The package, without dependencies:

- A door.

### Known limits

- One limit.

## [0.2.0] - 2026-11-20

### Fixed

- A fault.

## [0.1.0]
`;

describe('what is new, from the changelog', () => {
  it('is plain text about what a pilot sees, grouped by topic; the newest changes get the version of the build', () => {
    expect(newsOf(CHANGELOG, '0.3.0')).toEqual([
      {
        version: '0.3.0',
        changes: [
          { title: 'Changed', items: ['Write is quicker, and 2.5 is read.', 'Another.'] },
          { title: 'Connect', items: ['A bridge.'] },
          { title: 'Known limits', items: ['One limit.'] },
        ],
      },
      { version: '0.2.0', changes: [{ title: 'Fixed', items: ['A fault.'] }] },
      { version: '0.1.0', changes: [] },
    ]);
  });

  it('is read from the real changelog, short enough for the page, and without marks', () => {
    const [newest] = newsOf(readFileSync(join(root, 'CHANGELOG.md'), 'utf8'), '9.9.9');
    const items = newest?.changes.flatMap((change) => change.items) ?? [];
    expect(items.length).toBeGreaterThan(0);
    for (const item of items) expect(item).not.toMatch(/\*\*|`|\]\(|\n|^- /);
    for (const item of items) expect(item.length).toBeLessThanOrEqual(1000);
    expect(newest?.changes.map(({ title }) => title)).not.toContain('The package');
  });
});
