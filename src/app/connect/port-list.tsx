import type { KnownPort, SerialSettings } from '../../serial/index.js';
import { DEFAULT_SETTINGS, RATES } from '../../serial/index.js';
import { messages, portName } from '../messages/index.js';
import type { Link } from '../session/link.js';
import type { Session } from '../session/session.js';
import './port-list.css';

interface PortListProps {
  readonly session: Session;
  /** Called when connecting begins, which is shown elsewhere. */
  readonly onConnect: () => void;
}

/** The plugged-in adapters that were allowed before, the last used first. */
export function PortList({ session, onConnect }: PortListProps) {
  const { ports: words } = messages.value;
  const { link } = session;
  const ports = link.ports.value;
  if (ports.length === 0) return null;
  return (
    <section class="ports">
      <h2>{words.title}</h2>
      <ul>
        {ports.map((port, index) => (
          <PortRow key={`${port.key} ${index}`} {...{ session, port, onConnect }} />
        ))}
      </ul>
    </section>
  );
}

function PortRow({ session, port, onConnect }: PortListProps & { readonly port: KnownPort }) {
  const { ports: words, link } = messages.value;
  const rate = session.link.recordOf(port.key)?.foundRate;
  const name = portName(port);
  return (
    <li class="port">
      <button
        type="button"
        aria-label={words.connectTo(name)}
        disabled={session.engaged.value}
        onClick={() => {
          void session.timer.connectTo(port.port);
          onConnect();
        }}
      >
        <strong>{name}</strong>
      </button>
      {rate && <span class="hint">{link.lastRate(rate)}</span>}
      {port.port.forget && (
        <button
          type="button"
          class="quiet"
          aria-label={words.forgetNamed(name)}
          disabled={session.runner.busy.value}
          onClick={() => void session.link.forget(port)}
        >
          {words.forget}
        </button>
      )}
    </li>
  );
}

/** How to open the next port, for adapters that need something special. */
export function SerialSettingsForm({ link }: { readonly link: Link }) {
  const { ports: words } = messages.value;
  const settings = link.settings.value ?? DEFAULT_SETTINGS;
  const set = (part: Partial<SerialSettings>): void => {
    link.setSettings({ ...settings, ...part });
  };
  const rate = String(settings.baudRate);
  return (
    <details>
      <summary>{words.settings}</summary>
      <p class="hint">{words.settingsHint}</p>
      <div class="settings-grid">
        <Choice
          label={words.rate}
          value={rate}
          options={[
            ['find', words.findRate],
            ...[...RATES].sort((a, b) => a - b).map((baud): [string, string] => [String(baud), words.baud(baud)]),
          ]}
          onChoose={(value) => set({ baudRate: value === 'find' ? 'find' : Number(value) })}
        />
        <Choice
          label={words.parity}
          value={settings.parity}
          options={(['none', 'even', 'odd'] as const).map((parity) => [parity, words.parities[parity]])}
          onChoose={(parity) => set({ parity: parity as SerialSettings['parity'] })}
        />
        <Choice
          label={words.stopBits}
          value={String(settings.stopBits)}
          options={[
            ['1', '1'],
            ['2', '2'],
          ]}
          onChoose={(value) => set({ stopBits: value === '2' ? 2 : 1 })}
        />
        <Signal label={words.dtr} value={settings.dtr} onChoose={(dtr) => set({ dtr })} />
        <Signal label={words.rts} value={settings.rts} onChoose={(rts) => set({ rts })} />
      </div>
      {link.settings.value && (
        <button type="button" class="quiet" onClick={() => link.setSettings(null)}>
          {words.reset}
        </button>
      )}
    </details>
  );
}

interface SignalProps {
  readonly label: string;
  readonly value: boolean | null;
  readonly onChoose: (value: boolean | null) => void;
}

function Signal({ label, value, onChoose }: SignalProps) {
  const { signals } = messages.value.ports;
  return (
    <Choice
      label={label}
      value={value === null ? 'leave' : value ? 'on' : 'off'}
      options={(['leave', 'on', 'off'] as const).map((state) => [state, signals[state]])}
      onChoose={(state) => onChoose(state === 'leave' ? null : state === 'on')}
    />
  );
}

interface ChoiceProps {
  readonly label: string;
  readonly value: string;
  readonly options: readonly (readonly [value: string, text: string])[];
  readonly onChoose: (value: string) => void;
}

function Choice({ label, value, options, onChoose }: ChoiceProps) {
  return (
    <label class="choice">
      <span>{label}</span>
      <select value={value} onChange={(event) => onChoose(event.currentTarget.value)}>
        {options.map(([option, text]) => (
          <option key={option} value={option}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}
