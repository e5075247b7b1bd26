declare global {
  interface ImportMetaEnv {
    /** The version in package.json; the build fills it in. */
    readonly VITE_VERSION?: string;
  }
}

/** The version of this page. */
export const version: string = import.meta.env.VITE_VERSION ?? 'unreleased';
