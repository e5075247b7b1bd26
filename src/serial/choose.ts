import { ConnectionError } from './errors.js';
import type { SerialLike } from './types.js';

/** What a browser says about itself before anything is tried. */
export interface Surroundings {
  /** `navigator.serial`; undefined where the browser has none. */
  readonly serial?: SerialLike | undefined;
  /** `isSecureContext` of the page: loaded over https, or from this computer. */
  readonly isSecureContext: boolean;
  /**
   * Whether the Permissions-Policy of the page allows serial ports. Left out:
   * not known, as in browsers that do not say.
   */
  readonly policyAllows?: boolean | undefined;
}

/**
 * Whether this page can use serial ports at all.
 * @returns null when it can; otherwise the reason why not.
 */
export function availability(surroundings: Surroundings): 'insecure' | 'unsupported' | 'policy' | null {
  const { serial, isSecureContext, policyAllows } = surroundings;
  if (!isSecureContext && !serial) return 'insecure';
  if (policyAllows === false) return 'policy';
  return serial ? null : 'unsupported';
}

/** What a browser's refusal to list its ports, or to show its chooser, comes to. */
export function refused(error: unknown, policyAllows: boolean | undefined): ConnectionError {
  const name = error instanceof DOMException ? error.name : '';
  if (name === 'NotFoundError') return new ConnectionError('nothing-chosen', 'no port was chosen', error);
  // The browser gives the same error when nobody has clicked.
  if (name === 'SecurityError' && policyAllows === false) {
    return new ConnectionError('policy', 'the policy of the page forbids serial ports', error);
  }
  return new ConnectionError('not-allowed', 'the browser does not allow serial ports here', error);
}
