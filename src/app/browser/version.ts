declare global {
  interface ImportMetaEnv {
    /** The version in package.json; put in by the build. */
    readonly VITE_VERSION?: string;
  }
}

/** Which version of the program this is. */
export const version: string = import.meta.env.VITE_VERSION ?? 'unreleased';
