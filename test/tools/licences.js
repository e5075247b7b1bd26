// The licences of the built page and of its packages: the build finds out which packages the page contains, and puts
// their names and texts beside it. A package without a licence text fails the build.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * @typedef {object} Licence
 * @property {string} name of the package
 * @property {string} version
 * @property {string} licence `MIT`
 * @property {string} text in full
 */

/** The file beside the page. */
export const LICENCES_FILE = 'LICENSES.txt';
/** Of two licences to choose from, the shorter one. */
const FILES = [/^LICEN[SC]E-MIT/i, /^LICEN[SC]E/i, /^COPYING/i];
/**
 * Vite adds its own helper to a page. The rest of its licence file is about the packages that Vite is built
 * with.
 */
const OF_OTHERS = '# Licenses of bundled dependencies';

/**
 * @param {string} root the folder with node_modules
 * @returns {import('vite').Plugin}
 */
export function licences(root) {
  return {
    name: 'licences',
    apply: 'build',
    generateBundle(_options, bundle) {
      const chunks = Object.values(bundle).filter((file) => file.type === 'chunk');
      const source = textOf(licencesOf(modulesOf(chunks), root));
      this.emitFile({ type: 'asset', fileName: LICENCES_FILE, source });
    },
  };
}

/**
 * Fails the build of a script that contains a package: its licence would be missing.
 * @param {string} root the folder with node_modules
 * @returns {import('vite').Plugin}
 */
export function ownWorkOnly(root) {
  return {
    name: 'own-work-only',
    generateBundle(_options, bundle) {
      const modules = modulesOf(Object.values(bundle).filter((file) => file.type === 'chunk'));
      const [other] = packagesOf(modules, root);
      if (other) throw new Error(`${other} is in this script, but ${LICENCES_FILE} does not name it`);
    },
  };
}

/** @param {readonly { modules: object }[]} chunks */
function modulesOf(chunks) {
  return chunks.flatMap(({ modules }) => Object.keys(modules));
}

/**
 * The packages that modules belong to.
 * @param {readonly string[]} modules
 * @param {string} root the folder with node_modules
 * @returns {string[]} their folders
 */
function packagesOf(modules, root) {
  const folders = modules.flatMap((id) => {
    const [, maker] = /^\0(vite|rolldown)\//.exec(id) ?? [];
    if (maker) return [join(root, 'node_modules', maker)];
    const [folder] = /.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+/.exec(id) ?? [];
    return folder ? [folder] : [];
  });
  return [...new Set(folders)];
}

/**
 * @param {readonly string[]} modules
 * @param {string} root the folder with node_modules
 * @returns {Licence[]} this page's own first, then those of others in the order of their names
 */
export function licencesOf(modules, root) {
  const others = packagesOf(modules, root).map(licenceIn);
  return [licenceIn(root), ...others.sort((a, b) => (a.name < b.name ? -1 : 1))];
}

/**
 * @param {string} folder of a package
 * @returns {Licence}
 */
function licenceIn(folder) {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const files = readdirSync(folder);
  const file = FILES.map((pattern) => files.find((each) => pattern.test(each))).find(Boolean);
  const [text = ''] = (file ? readFileSync(join(folder, file), 'utf8') : '').split(OF_OTHERS);
  if (!text.trim() || !license) throw new Error(`${name} is in the page, but no text of its licence was found`);
  return { name, version, licence: license.replace(/^\(|\)$/g, ''), text: text.trim().replaceAll('\r\n', '\n') };
}

/** @param {readonly Licence[]} list */
function textOf(list) {
  const head = 'This page and the work of others that it contains, each with its licence:';
  const parts = list.map(({ name, version, licence, text }) => `${name} ${version}, ${licence}\n\n${text}`);
  return `${[head, ...parts].join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}
