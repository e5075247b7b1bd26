import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

const css = readFileSync(`${import.meta.dirname}/../../../src/app/ui/tokens.css`, 'utf8');

/** The colours of one set, by name without its dashes. @param at of its two schemes: 0 for light, 1 for dark */
function coloursAfter(selector: string, at: 0 | 1 = 0): ReadonlyMap<string, string> {
  const sets = css.split(`${selector} {\n`).slice(1);
  const [set = ''] = sets.map((each) => each.split('}')[0] ?? '').filter((each) => each.includes('--ink: '));
  const declared = [...set.matchAll(/--([\w-]+): (?:light-dark\()?(#[0-9a-f]{6})(?:, (#[0-9a-f]{6})\))?;/g)];
  return new Map(declared.map(([, name = '', light = '', dark = light]) => [name, at === 0 ? light : dark]));
}

/** A colour of a theme, also one that is made of others in every theme. */
function colour(theme: ReadonlyMap<string, string>, name: string): string {
  const [, made = ''] = new RegExp(`--${name}: ((?:var|color-mix)\\(.*\\));`).exec(css) ?? [];
  const parts = [...made.matchAll(/var\(--([\w-]+)\)/g)].map(([, part = '']) => colour(theme, part));
  const [one = '', other = one] = parts;
  const share = Number(/(\d+)%/.exec(made)?.[1] ?? 100) / 100;
  return theme.get(name) ?? mixed(one, other, share);
}

function mixed(one: string, other: string, share: number): string {
  const part = (of: string, at: number): number => Number.parseInt(of.slice(at, at + 2), 16);
  const parts = [1, 3, 5].map((at) => Math.round(part(one, at) * share + part(other, at) * (1 - share)));
  return `#${parts.map((each) => each.toString(16).padStart(2, '0')).join('')}`;
}

const light = coloursAfter(':root');
const dark = coloursAfter(':root', 1);
const sun = coloursAfter("[data-theme='sun']");

/** 1 to 21, as WCAG counts it. */
function contrast(one: string, other: string): number {
  const [darker = 0, brighter = 0] = [one, other].map(luminance).sort((a, b) => a - b);
  return (brighter + 0.05) / (darker + 0.05);
}

function luminance(of: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(of.slice(at, at + 2), 16) / 255;
    return part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/** What is read on what, and how much of a contrast it has at least: in a room, and in the sun. */
const READ: readonly [inks: readonly string[], grounds: readonly string[], room: number, sun: number][] = [
  [['ink'], ['panel', 'field', 'bg'], 15, 21],
  [['ink'], ['changed-bg', 'danger-bg', 'good-bg', 'accent-bg', 'motor-bg'], 11, 16],
  [['muted'], ['panel', 'field', 'bg'], 7, 17],
  [['accent', 'accent-strong', 'changed', 'danger', 'good', 'motor'], ['panel', 'field', 'bg'], 7, 9],
  [['on-accent'], ['accent', 'accent-strong'], 7, 9],
  [['accent'], ['accent-bg'], 6, 9],
  [['changed'], ['changed-bg'], 7, 16],
  [['danger'], ['danger-bg'], 7, 9],
  [['good'], ['good-bg'], 7, 9],
  [['motor'], ['motor-bg'], 7, 8],
  [['muted'], ['changed-bg', 'danger-bg', 'good-bg', 'accent-bg', 'motor-bg'], 6, 12],
  [['off'], ['panel', 'field', 'bg'], 4.5, 6],
  [['servo-1', 'servo-2', 'servo-3', 'servo-4', 'servo-5', 'servo-6'], ['panel', 'field'], 5, 8],
  [['field-edge'], ['panel', 'field', 'bg'], 3, 15],
  [['on-selection'], ['selection'], 15, 21],
];

describe('the colours of each theme', () => {
  it.each([
    ['light', light],
    ['dark', dark],
    ['sun', sun],
  ])('%s: text has the contrast that old eyes need', (theme, colours) => {
    const weak = READ.flatMap(([inks, grounds, inRoom, inSun]) =>
      inks.flatMap((ink) =>
        grounds.flatMap((ground) => {
          const found = contrast(colour(colours, ink), colour(colours, ground));
          const needed = theme === 'sun' ? inSun : inRoom;
          return found >= needed ? [] : [`${ink} on ${ground}: ${found.toFixed(2)}, not ${needed}`];
        }),
      ),
    );
    expect(weak).toEqual([]);
  });

  it('have the same names: a theme is one set of values', () => {
    expect([...sun.keys()].sort()).toEqual([...light.keys()].sort());
  });
});
