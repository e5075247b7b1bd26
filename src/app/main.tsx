import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app.js';
import type { AppModels } from './models.js';
import { registerOffline } from './offline.js';
import { plugSimulatedTimer } from './simulated-timer.js';
import { Session } from './state/session.js';
import { UpdateOffer } from './state/update-offer.js';
import { WriteFlow } from './state/write-flow.js';
import { DraftStore } from './storage/drafts.js';
import './styles/base.css';
import './styles/frame.css';
import './styles/program.css';
import './styles/write.css';

const session = new Session({
  surroundings: { serial: navigator.serial as Serial | undefined, isSecureContext },
  store: new DraftStore(),
  plugSimulated: plugSimulatedTimer,
});
const models: AppModels = { session, write: new WriteFlow(session), update: new UpdateOffer(session) };

const warn = (event: BeforeUnloadEvent): void => event.preventDefault();
effect(() => {
  // Leaving in the middle of a write is the one thing that a reload cannot mend by itself.
  if (models.write.current.value?.step === 'running') addEventListener('beforeunload', warn);
  else removeEventListener('beforeunload', warn);
});

registerOffline({ onUpdateReady: models.update.offer, whenFree: models.update.whenFree });
await session.start();
render(<App models={models} />, document.getElementById('app') as HTMLElement);
