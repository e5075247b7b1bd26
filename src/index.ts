export { clientPlaceholder } from './client/index.js';
