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
}

/** What to do, step by step, folded up under the notice. */
export function ConnectionHelp({ code, platform, info }: ConnectionHelpProps) {
  useEffect(() => () => document.documentElement.removeAttribute('data-help'), []);
  if (helpFor(code, { platform, info, address: location.href }).here.length === 0) return null;
  return (
    <details key={code} class="help" onToggle={({ currentTarget }) => keepInSight(currentTarget)}>
      <summary>{messages.value.help.title}</summary>
      <HelpSteps code={code} platform={platform} info={info} />
    </details>
  );
}

/** What to do, step by step: first for this system, then the others, folded up. */
export function HelpSteps({ code, platform, info }: ConnectionHelpProps) {
  const { on, systems } = messages.value.help;
  const { here, elsewhere } = helpFor(code, { platform, info, address: location.href });
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
