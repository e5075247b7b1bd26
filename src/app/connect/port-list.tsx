import type { SerialSettings } from '../../serial/index.js';
import { DEFAULT_SETTINGS, RATES } from '../../serial/index.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { portName } from '../messages/names.js';
import type { Link } from '../timer/link.js';
import { Choice } from '../ui/choice.js';
import type { Session } from '../work/session.js';
import './port-list.css';

interface PortListProps {
  readonly session: Session;
  /** Called when connecting begins, which is shown elsewhere. */
  readonly onConnect: () => void;
}

/** The plugged-in adapters that were allowed before, the last used first. */
export function PortList({ session, onConnect }: PortListProps) {
  const { header, of } = messages.value;
  const { ports: words } = moreMessages.value;
  const { link, timer, engaged, runner } = session;
  const ports = link.ports.value;
  if (ports.length === 0) return null;
  return (
    <section class="stack">
      <h2>{words.title}</h2>
      <ul class="stack">
        {ports.map((port, index) => {
          const name = portName(port);
          return (
            <li class="row port" key={`${port.key} ${index}`}>
              <strong>{name}</strong>
              <button
                type="button"
                aria-label={of({ button: header.connect, name })}
                disabled={engaged.value}
                onClick={() => {
                  void timer.connectTo(port.port);
                  onConnect();
                }}
              >
                {header.connect}
              </button>
              {port.port.forget && (
                <button
                  type="button"
                  class="quiet"
                  aria-label={of({ button: words.forget, name })}
                  disabled={runner.busy.value}
                  onClick={() => void link.forget(port)}
                >
                  {words.forget}
                </button>
              )}
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/**
 * How to open the next port, for adapters that need something special.
 * @param expert whether to ask for what no adapter is known to need: no document states the form of a byte.
 */
export function SerialSettingsForm({ link, expert }: { readonly link: Link; readonly expert: boolean }) {
  const { ports: words } = moreMessages.value;
  const settings = link.settings.value ?? DEFAULT_SETTINGS;
  const set = (part: Partial<SerialSettings>): void => {
    link.setSettings({ ...settings, ...part });
  };
  return (
    <details>
      <summary>{words.settings}</summary>
      <p class="hint">{words.settingsHint}</p>
      <div class="settings-grid">
        <Choice
          label={words.rate}
          choices={['find', ...[...RATES].sort((a, b) => a - b)] as const}
          nameOf={(rate) => (rate === 'find' ? words.findRate : words.baud({ rate }))}
          chosen={settings.baudRate}
          onChoose={(baudRate) => set({ baudRate })}
        />
        {expert && (
          <>
            <Choice
              label={words.parity}
              choices={['none', 'even', 'odd'] as const}
              nameOf={(parity) => words.parities[parity]}
              chosen={settings.parity}
              onChoose={(parity) => set({ parity })}
            />
            <Choice
              label={words.stopBits}
              choices={[1, 2] as const}
              nameOf={String}
              chosen={settings.stopBits}
              onChoose={(stopBits) => set({ stopBits })}
            />
          </>
        )}
        {(['dtr', 'rts'] as const).map((line) => (
          <Choice
            key={line}
            label={words[line]}
            choices={[null, true, false]}
            nameOf={(level) => words.signals[level === null ? 'leave' : level ? 'on' : 'off']}
            chosen={settings[line]}
            onChoose={(level) => set({ [line]: level })}
          />
        ))}
      </div>
      {link.settings.value && (
        <button type="button" class="quiet" onClick={() => link.setSettings(null)}>
          {words.reset}
        </button>
      )}
    </details>
  );
}
