import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Session } from './state/session.js';
import type { UpdateOffer } from './state/update-offer.js';
import type { WriteFlow } from './state/write-flow.js';

/** The models that the screens read and call. */
export interface AppModels {
  readonly session: Session;
  readonly write: WriteFlow;
  readonly update: UpdateOffer;
}

export const Models = createContext<AppModels | null>(null);

/** The models of the program that this component is part of. */
export function useModels(): AppModels {
  const models = useContext(Models);
  if (!models) throw new Error('outside of the app');
  return models;
}
