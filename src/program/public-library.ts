/**
 * What a pilot keeps: models, settings, flights; their file and a link that carries a setting.
 * @module library
 */

export {
  DUTIES,
  type Duty,
  type Flight,
  type Library,
  type Model,
  requireProgram,
  type ServoUse,
  type Setting,
  type SettingSource,
  type SettingVersion,
  SOURCES,
} from './library.js';
export {
  type EntryFacts,
  type FactsOf,
  formatLibraryFile,
  type LibraryFile,
  parseLibraryFile,
  type VerifiedMemory,
} from './library-file.js';
export { decodeLink, encodeLink, LINK_MARK, type SharedSetting } from './link-code.js';
