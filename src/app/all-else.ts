/**
 * Everything that neither the start nor the program view needs, in one file: each file costs a request, and these share
 * much of their code.
 */
export { BenchPanel } from './bench/bench-panel.js';
export { ComparePage } from './compare/compare-page.js';
export { Dialogs } from './dialogs.js';
export { FlightsView } from './flights/flights-view.js';
export { FlyingThis } from './flights/flying-this.js';
export { filesOf, LibraryFileNotice } from './library-files.js';
export { LibraryPage } from './library-page.js';
export { LinePanel } from './line/line-panel.js';
export { MemoriesPage } from './memories/memories-page.js';
export { PrintView } from './print/print-view.js';
export { ModelLine } from './recognition/model-line.js';
export { HelpView } from './shell/help-view.js';
export { SettingsView } from './shell/settings-view.js';
