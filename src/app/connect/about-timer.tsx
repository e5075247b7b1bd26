import type { AssumedQuirks } from '../../client/index.js';
import type { Identity } from '../../protocol/index.js';
import { dotted } from '../messages/dotted.js';
import { identityText } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { portName } from '../messages/names.js';
import { settledTexts } from '../messages/settled-text.js';
import { Check } from '../ui/check.js';
import type { Session } from '../work/session.js';

/** The place of the walk that settles what is open, in the view of the settings. */
export const SETTLE = 'settle';

type Assumption = keyof AssumedQuirks & keyof typeof moreMessages.value.aboutTimer.assumptions;

/** What the connected timer is, and how it differs from others. The numbers of its line are in the report. */
export function AboutTimer({ session }: { readonly session: Session }) {
  const { alike, header } = messages.value;
  const { aboutTimer: about, ports } = moreMessages.value;
  const connection = session.link.connection.value;
  if (!connection) return null;
  // Findings of a job or a write are shown when it ends.
  const busy = session.runner.busy.value;
  const { client, identity, settings } = connection;
  const port = session.link.simulated.value ? header.simulated : portName(connection);
  const found = [...client.quirksFound].map(([code, params]) =>
    code === 'replies-alike' ? alike.title({ request: Object.keys(params).join(', ') }) : about.quirkNames[code],
  );
  return (
    <details>
      <summary>{about.title}</summary>
      <div class="stack">
        <p>{identityText(identity)}</p>
        <p class="hint">{dotted([port, ports.baud({ rate: settings.baudRate })])}</p>
        {client.damageSeen && <p class="bad-text">{about.damage}</p>}
        {client.strays > 0 && <p class="bad-text">{about.crowd}</p>}
        <h2>{about.found}</h2>
        {found.length === 0 ? (
          <p class="hint">{about.nothingFound}</p>
        ) : (
          <ul>
            {/* Several findings may have one sentence. */}
            {[...new Set(found)].map((said) => (
              <li key={said}>{said}</li>
            ))}
          </ul>
        )}
        <Settled session={session} identity={identity} />
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
        {(Object.keys(about.assumptions) as Assumption[]).some((name) => client.quirksAssumed[name] !== undefined) && (
          <button type="button" disabled={busy} onClick={() => void session.timer.forgetAssumed()}>
            {about.forget}
          </button>
        )}
      </div>
    </details>
  );
}

/** What was settled with timers of its kind, and the way to settle more. */
function Settled({ session, identity }: { readonly session: Session; readonly identity: Identity }) {
  const answers = session.settled.of(identity, session.link.simulated.value);
  const settled = settledTexts(answers, identity.timerClass).filter(([, text]) => text !== null);
  return (
    <>
      <a class="alone" href={`#settings/${SETTLE}`}>
        {moreMessages.value.settle.title}
      </a>
      {settled.length > 0 && (
        <ul>
          {settled.map(([name, text]) => (
            <li key={name}>
              {messages.value.about({ name })} {text}
            </li>
          ))}
        </ul>
      )}
    </>
  );
}
