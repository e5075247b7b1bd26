import type { AssumedQuirks } from '../../client/index.js';
import { messages, portName, timerName } from '../messages/index.js';
import { useModels } from '../models.js';

/** What is known of the timer at hand: what it is, how it is reached, and what it does in its own way. */
export function AboutTimer() {
  const { session, write } = useModels();
  const { aboutTimer: about, header } = messages.value;
  const connection = session.connection.value;
  // What a job or a write has found out is told when it ends.
  const busy = session.busy.value || write.current.value?.step === 'running';
  if (!connection) return null;
  const { client, identity, settings } = connection;
  const { functions, memories, servos } = identity;
  const errors = [...client.lineErrors].map(([kind, count]) => about.count(about.lineErrorNames[kind], count));
  const found = [...client.quirksFound.keys()];
  const facts: [string, string][] = [
    [about.kind, `${timerName(identity)}, ${header.firmware(identity.firmware)}`],
    [about.layout, about.layoutOf(functions, memories, servos)],
    [about.port, session.link.simulated.value ? header.simulated : portName(connection)],
    [about.rate, messages.value.ports.baud(settings.baudRate)],
    [about.repeats, String(client.repeats)],
    [about.lineErrors, errors.join(', ') || about.none],
  ];
  return (
    <details class="about-timer">
      <summary>{about.title}</summary>
      <dl>
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {client.damageSeen && <p class="bad-text">{about.damage}</p>}
      <h2>{about.found}</h2>
      {found.length === 0 ? (
        <p class="hint">{about.nothingFound}</p>
      ) : (
        <ul class="quirks">
          {found.map((code) => (
            <li key={code}>{about.quirkNames[code]}</li>
          ))}
        </ul>
      )}
      <h2>{about.assumed}</h2>
      {(Object.keys(about.assumptions) as (keyof AssumedQuirks & keyof typeof about.assumptions)[]).map((name) => (
        <label class="check" key={name}>
          <input
            type="checkbox"
            checked={client.quirksAssumed[name] === true}
            disabled={busy}
            onChange={(event) => void session.assume({ [name]: event.currentTarget.checked })}
          />
          {about.assumptions[name]}
        </label>
      ))}
      <p class="hint">{about.assumedHint}</p>
    </details>
  );
}
