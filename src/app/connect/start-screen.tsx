import type { Platform } from '../browser/platform.js';
import { clockText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { memoryName, timerName } from '../messages/names.js';
import { SmallLanes } from '../timeline/small-lanes.js';
import { LanguageChoice } from '../ui/language-choice.js';
import { NoticeText } from '../ui/notice-text.js';
import type { Session } from '../work/session.js';
import { ConnectButtons } from './connect-buttons.js';
import { ConnectionHelp, connectionSaid } from './connection-help-view.js';
import { EXAMPLE } from './example-program.js';
import type { Installation } from './installation.js';
import { hasStage, LinkStage } from './link-stage.js';
import { KeptCard, Simulated } from './start-cards.js';
import { StepList } from './step-list.js';
import './start-screen.css';

interface StartScreenProps {
  readonly session: Session;
  readonly installation: Installation;
  readonly platform: Platform;
}

/**
 * The start, before anything was read: Connect with its three steps, what works without a timer, and what this device
 * keeps. On a phone, both ways to a timer are in sight at once.
 */
export function StartScreen({ session, installation, platform }: StartScreenProps) {
  const { start, link } = messages.value;
  const { unavailable } = session.link;
  if (hasStage(session)) return <LinkStage session={session} platform={platform} />;
  return (
    <div class="stack start-screen">
      <div class="hero">
        <div class="stack gap-4 hero-main">
          <h1>{start.title}</h1>
          <p class="lead">{start.lead}</p>
          {unavailable ? (
            <div class="notice bad">
              <NoticeText said={connectionSaid(unavailable, platform)} />
              <ConnectionHelp code={unavailable} platform={platform} link={session.link} />
            </div>
          ) : (
            <>
              <div class="buttons">
                <ConnectButtons session={session} large />
              </div>
              {platform.system === 'android' && <p class="hint">{start.android}</p>}
              {platform.browser === 'firefox' && <p class="hint">{start.firefox}</p>}
              <StepList
                steps={[start.adapter, link.stages.steps.switch, link.stages.steps.near].map((text) => ({ text }))}
              />
            </>
          )}
        </div>
        <KeptPicture session={session} />
      </div>
      <div class="start-cards">
        <Simulated session={session} />
        <KeptCard session={session} />
      </div>
      <OnThisDevice installation={installation} />
    </div>
  );
}

/** Whether the page works without a network, how to install it, and a link to the settings. */
function OnThisDevice({ installation }: Pick<StartScreenProps, 'installation'>) {
  const { start, views } = messages.value;
  const install = installation.install.value;
  return (
    <p class="row gap-4 on-device">
      {installation.ready.value && <span class="ready-offline">{start.readyOffline}</span>}
      {install && (
        <button type="button" onClick={install}>
          {start.install}
        </button>
      )}
      <a class="alone" href="#help">
        {views.names.help}
      </a>
      <a class="alone" href="#settings">
        {views.names.settings}
      </a>
      <LanguageChoice />
    </p>
  );
}

/** Draws the last program that this device has kept, or an example, with its figures. */
function KeptPicture({ session }: Pick<StartScreenProps, 'session'>) {
  const { start, program: words } = messages.value;
  const kept = session.backups.list.value.find(({ simulated }) => !simulated);
  const program = kept?.program ?? EXAMPLE;
  const [dt, motor] = keyFigures(program);
  const memory = program.memory === null ? '' : `, ${memoryName(program.memory)}`;
  return (
    <figure class="stack panel kept-picture">
      <figcaption>
        <strong>{kept ? `${timerName(program.identity)}${memory}` : start.picture.example}</strong>
        {kept && <span>{start.picture.kept({ time: clockText(kept.savedAt) })}</span>}
      </figcaption>
      <div class="kept-lanes">
        <SmallLanes program={program} />
      </div>
      <p>
        <span>{motor && `${words.motorStop} ${motor.text}`}</span>
        <span>{dt && `${words.dt} ${dt.text}`}</span>
      </p>
    </figure>
  );
}
