import type { Platform } from '../browser/platform.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { NoticeText } from '../ui/notice-text.js';
import { AboutTimer } from './about-timer.js';
import { ConnectButtons } from './connect-buttons.js';
import { ConnectionHelp, connectionSaid } from './connection-help-view.js';
import { PortList, SerialSettingsForm } from './port-list.js';
import './start-screen.css';

interface StartScreenProps {
  readonly session: Session;
  readonly platform: Platform;
}

/** Before anything was read: Connect, or try a simulated timer. */
export function StartScreen({ session, platform }: StartScreenProps) {
  const { start, classNames } = messages.value;
  const { unavailable } = session.link;
  return (
    <div class="start-screen">
      <h1>{start.title}</h1>
      <p class="lead">{start.lead}</p>
      {unavailable ? (
        <div class="notice bad">
          <NoticeText said={connectionSaid(unavailable, platform)} />
          <ConnectionHelp code={unavailable} platform={platform} info={null} />
        </div>
      ) : (
        <div class="start-connect">
          <ConnectButtons session={session} large />
          <p class="hint">{start.connectHint}</p>
        </div>
      )}
      {!unavailable && <PortList session={session} />}
      {!unavailable && <SerialSettingsForm link={session.link} />}
      <AboutTimer session={session} />
      <section class="start-simulated">
        <h2>{start.simulatedTitle}</h2>
        <p>{start.simulatedLead}</p>
        <div class="buttons">
          {(['Q', 'B', 'E'] as const).map((timerClass) => (
            <button
              type="button"
              key={timerClass}
              disabled={session.engaged.value}
              onClick={() => void session.trySimulated(timerClass)}
            >
              {start.simulated(classNames[timerClass] ?? timerClass)}
            </button>
          ))}
        </div>
      </section>
    </div>
  );
}
