import type { AssumedQuirks } from '../../client/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { messages, portKeyName, portName, timerName } from '../messages/index.js';
import type { Assumed } from '../session/link.js';
import { identityOfKind, kindKey } from '../session/record-keys.js';
import type { Session } from '../session/session.js';
import { Check } from '../ui/check.js';
import './about-timer.css';

type Assumption = keyof AssumedQuirks & keyof typeof messages.value.aboutTimer.assumptions;

/**
 * What is known about the connected timer, and what is assumed about timers on known ports. Shown whatever the
 * connection does.
 */
export function AboutTimer({ session }: { readonly session: Session }) {
  const { aboutTimer: about } = messages.value;
  const { link } = session;
  const connection = link.connection.value;
  const others = link.assumed.value.filter((assumed) => !connection || !isOf(assumed, connection));
  const isKnown = others.length > 0 || link.ports.value.length > 0 || 'port' in link.state.value;
  if (!connection && !isKnown) return null;
  return (
    <details class="about-timer">
      <summary>{about.title}</summary>
      {connection ? <AtHand session={session} connection={connection} /> : <p class="hint">{about.notConnected}</p>}
      {(others.length > 0 || !connection) && <h2>{about.others}</h2>}
      {others.length === 0 && !connection && <p>{about.nothingAssumed}</p>}
      {others.map((assumed) => (
        <Remembered key={`${assumed.portKey} ${assumed.kind}`} session={session} assumed={assumed} />
      ))}
    </details>
  );
}

interface AtHandProps {
  readonly session: Session;
  readonly connection: TimerConnection;
}

/** What the timer is, how it is connected, and how it differs from others. */
function AtHand({ session, connection }: AtHandProps) {
  const { aboutTimer: about, alike, header } = messages.value;
  // Findings of a job or a write are shown when it ends.
  const busy = session.runner.busy.value;
  const { client, identity, settings, portKey } = connection;
  const { functions, memories, servos } = identity;
  const errors = [...client.lineErrors].map(([kind, count]) => about.count(about.lineErrorNames[kind], count));
  const found = [...client.quirksFound];
  const facts: [string, string][] = [
    [about.kind, `${timerName(identity)}, ${header.firmware(identity.firmware)}`],
    [about.layout, about.layoutOf(functions, memories, servos)],
    [about.port, session.link.simulated.value ? header.simulated : portName(connection)],
    [about.rate, messages.value.ports.baud(settings.baudRate)],
    [about.delay, about.delayOf(client.delay)],
    [about.repeats, String(client.repeats)],
    [about.strays, String(client.strays)],
    [about.lineErrors, errors.join(', ') || about.none],
  ];
  return (
    <>
      <dl>
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {client.damageSeen && <p class="bad-text">{about.damage}</p>}
      {client.strays > 0 && <p class="bad-text">{about.crowd}</p>}
      <h2>{about.found}</h2>
      {found.length === 0 ? (
        <p class="hint">{about.nothingFound}</p>
      ) : (
        <ul class="quirks">
          {found.map(([code, params]) => (
            <li key={code}>
              {code === 'replies-alike' ? alike.title(Object.keys(params).join(', ')) : about.quirkNames[code]}
            </li>
          ))}
        </ul>
      )}
      <h2>{about.assumed}</h2>
      {(Object.keys(about.assumptions) as Assumption[]).map((name) => (
        <Check
          key={name}
          checked={client.quirksAssumed[name] === true}
          disabled={busy}
          onChange={(checked) => void session.timer.assume({ [name]: checked })}
        >
          {about.assumptions[name]}
        </Check>
      ))}
      <p class="hint">{about.assumedHint}</p>
      {Object.keys(client.quirksAssumed).length > 0 && (
        <button
          type="button"
          disabled={busy}
          onClick={() => void session.timer.forgetAssumed({ portKey, kind: kindKey(identity, false) })}
        >
          {about.forget}
        </button>
      )}
    </>
  );
}

/** Earlier findings about a kind of timer on a port. */
function Remembered({ session, assumed }: { readonly session: Session; readonly assumed: Assumed }) {
  const { aboutTimer: about, header } = messages.value;
  const identity = identityOfKind(assumed.kind);
  const timer = identity ? `${timerName(identity)}, ${header.firmware(identity.firmware)}` : assumed.kind;
  const kind = about.kindAt(timer, portKeyName(assumed.portKey));
  const names = (Object.keys(about.assumptions) as Assumption[]).filter((name) => assumed.quirks[name] !== undefined);
  return (
    <div class="backup">
      <p>
        <strong>{kind}</strong>
      </p>
      <ul class="quirks">
        {names.map((name) => (
          <li key={name}>
            {about.assumptions[name]}
            {assumed.quirks[name] ? '' : about.not}
          </li>
        ))}
      </ul>
      <button
        type="button"
        class="quiet"
        aria-label={about.forgetOf(kind)}
        disabled={session.runner.busy.value}
        onClick={() => void session.timer.forgetAssumed(assumed)}
      >
        {about.forget}
      </button>
    </div>
  );
}

function isOf({ portKey, kind }: Assumed, { portKey: port, identity }: TimerConnection): boolean {
  return portKey === port && kind === kindKey(identity, false);
}
