import { onDemand } from '../ui/on-demand.js';

/** The texts are long, and few want to read them. */
export const licenceList = onDemand(async () => (await import('./licence-list.js')).LicenceList);
