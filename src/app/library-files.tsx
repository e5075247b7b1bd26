import { FileNotice } from './library/files/file-notice.js';
import { LibraryFiles } from './library/files/library-files.js';
import type { AppModels } from './models.js';

const made = new WeakMap<AppModels, LibraryFiles>();

/** Export and import. Built on first use: the page works before this part is loaded. */
export function filesOf(models: AppModels): LibraryFiles {
  const { session, keeping } = models;
  const files = made.get(models) ?? new LibraryFiles({ library: session.library, kept: keeping.kept });
  made.set(models, files);
  return files;
}

/** What was done with files last. */
export function LibraryFileNotice({ models }: { readonly models: AppModels }) {
  return <FileNotice files={filesOf(models)} />;
}
