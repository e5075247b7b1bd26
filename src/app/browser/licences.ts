/** The licence of a package that the built page contains. */
export interface Licence {
  readonly name: string;
  readonly version: string;
  /** `MIT` */
  readonly licence: string;
  /** The full text. */
  readonly text: string;
}

declare global {
  interface ImportMetaEnv {
    /** The licences as JSON. The build fills it in, because it knows what is in the page. */
    readonly VITE_LICENCES?: string;
  }
}

/** Empty when the page is not built. */
export const licences: readonly Licence[] = JSON.parse(import.meta.env.VITE_LICENCES ?? '[]');
