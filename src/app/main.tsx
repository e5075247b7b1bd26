import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app.js';
import { createModels } from './models.js';
import { registerOffline } from './offline.js';
import { platformOf } from './platform.js';
import { plugRecording, plugSimulatedTimer } from './simulated-timer.js';
import { openTabChannel } from './state/other-tabs.js';
import { TabNumber, tabMemory } from './state/tab-number.js';
import { browserStorage } from './storage/index.js';
import './styles/base.css';
import './styles/bench.css';
import './styles/fields.css';
import './styles/frame.css';
import './styles/help.css';
import './styles/line.css';
import './styles/link.css';
import './styles/overview.css';
import './styles/preview.css';
import './styles/program.css';
import './styles/range.css';
import './styles/table.css';
import './styles/timeline.css';
import './styles/write.css';
import { onWake } from './wake.js';

const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
const models = createModels({
  surroundings: {
    serial: navigator.serial as Serial | undefined,
    isSecureContext,
    policyAllows: featurePolicy?.allowsFeature('serial'),
  },
  storage: browserStorage(),
  tab: new TabNumber((navigator.locks as LockManager | undefined) ?? null, tabMemory),
  plugSimulated: plugSimulatedTimer,
  plugRecording,
  platform: platformOf(navigator),
  channel: openTabChannel(),
});
const { session } = models;

const warn = (event: BeforeUnloadEvent): void => event.preventDefault();
effect(() => {
  // Leaving in the middle of a write is the one thing that a reload cannot mend by itself.
  const isRunning = models.write.current.value?.step === 'running' || models.memories.current.value?.step === 'running';
  if (isRunning) addEventListener('beforeunload', warn);
  else removeEventListener('beforeunload', warn);
});

registerOffline({ onUpdateReady: models.update.offer, whenFree: models.update.whenFree });
onWake(() => session.link.recheck());
document.addEventListener('visibilitychange', () => document.hidden && void models.bench.stopFollowing());
models.theme.follow(document, matchMedia('(prefers-color-scheme: dark)'));
await session.start();
render(<App models={models} />, document.getElementById('app') as HTMLElement);
