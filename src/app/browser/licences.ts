/** The licence of a package that the built page contains. */
export interface Licence {
  readonly name: string;
  readonly version: string;
  /** `MIT` */
  readonly licence: string;
  /** In full. */
  readonly text: string;
}

declare global {
  interface ImportMetaEnv {
    /** The licences as JSON; put in by the build, which knows what it has put into the page. */
    readonly VITE_LICENCES?: string;
  }
}

/** Empty where the page is not built. */
export const licences: readonly Licence[] = JSON.parse(import.meta.env.VITE_LICENCES ?? '[]');
