import { onDemand } from '../ui/on-demand.js';

/** Loaded on demand: the texts are long, and few people read them. */
export const licenceList = onDemand(async () => (await import('./licence-list.js')).LicenceList);
