import { useEffect } from 'preact/hooks';
import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';
import { type Platform, whyUnsupported } from '../browser/platform.js';
import { messages, type Said } from '../messages/index.js';
import { CopyText } from '../ui/copy-text.js';
import { type HelpCode, type HelpStep, helpFor } from './connection-help.js';
import './connection-help-view.css';

interface ConnectionHelpProps {
  readonly code: HelpCode;
  readonly platform: Platform;
  /** The information of the port; null when none was chosen. */
  readonly info: PortInfo | null;
  /** Whether the pilot has set a rate. */
  readonly rateSet: boolean;
}

/** What to do, step by step, folded up under the notice. */
export function ConnectionHelp(props: ConnectionHelpProps) {
  const { code } = props;
  const { help } = messages.value;
  useEffect(() => () => document.documentElement.removeAttribute('data-help'), []);
  if (adviceFor(props).here.length === 0) return null;
  return (
    <details key={code} class="help" onToggle={({ currentTarget }) => keepInSight(currentTarget)}>
      <summary>{code === 'still-waiting' ? help.titleStill : help.title}</summary>
      <HelpSteps {...props} />
    </details>
  );
}

/** What to do, step by step: first for this system, then the others, folded up. */
export function HelpSteps(props: ConnectionHelpProps) {
  const { on, systems } = messages.value.help;
  const { here, elsewhere } = adviceFor(props);
  return (
    <>
      <Steps steps={here} />
      {elsewhere.map(({ system, steps }) => (
        <details key={system}>
          <summary>{on(systems[system])}</summary>
          <Steps steps={steps} />
        </details>
      ))}
    </>
  );
}

function adviceFor({ code, ...situation }: ConnectionHelpProps) {
  return helpFor(code, { ...situation, address: location.href });
}

/** The sentence about a failed connection. Without Web Serial it is about this browser. */
export function connectionSaid(code: ConnectionErrorCode, platform: Platform): Said {
  const { connection, help } = messages.value;
  const reason = code === 'unsupported' ? whyUnsupported(platform) : null;
  return reason ? help.unsupported[reason] : connection[code];
}

function Steps({ steps }: { readonly steps: readonly HelpStep[] }) {
  const { help } = messages.value;
  return (
    <ol>
      {steps.map(({ code, copy }) => (
        <li key={code}>
          <p>{help.steps[code]}</p>
          {copy.map((text) => (
            <CopyText key={text} text={text} />
          ))}
        </li>
      ))}
    </ol>
  );
}

/** The help opens in the head of the page, which scrolls away while it is as long as this. It must stay in sight. */
function keepInSight(help: HTMLDetailsElement): void {
  const top = help.closest('.top');
  document.documentElement.toggleAttribute('data-help', help.open && top !== null);
  if (help.open) top?.scrollIntoView();
}
