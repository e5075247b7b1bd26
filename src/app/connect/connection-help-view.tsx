import { useEffect } from 'preact/hooks';
import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';
import { type Platform, whyUnsupported } from '../browser/platform.js';
import { unsupported } from '../messages/en-browsers.js';
import { messages, type Said } from '../messages/index.js';
import { type HelpCode, type HelpStep, helpFor } from './connection-help.js';
import { CopyText } from './copy-text.js';
import './connection-help-view.css';

interface ConnectionHelpProps {
  readonly code: HelpCode;
  readonly platform: Platform;
  /** The information of the port; null when none was chosen. */
  readonly info: PortInfo | null;
  /** Whether the pilot has set a rate. */
  readonly rateSet: boolean;
}

/** The steps for every system: docs/connection.md, put there by the build. */
const ALL_STEPS = 'help/connection.html';

/** What to do, step by step, folded up under the notice. */
export function ConnectionHelp(props: ConnectionHelpProps) {
  useEffect(() => () => document.documentElement.removeAttribute('data-help'), []);
  if (stepsFor(props).length === 0) return null;
  return (
    <details key={props.code} class="help" onToggle={({ currentTarget }) => keepInSight(currentTarget)}>
      <summary>{messages.value.help.title}</summary>
      <HelpSteps {...props} />
    </details>
  );
}

/** What to do on this system, and a link to the steps for every other. */
export function HelpSteps(props: ConnectionHelpProps) {
  const { help } = messages.value;
  const steps = stepsFor(props);
  return (
    <>
      {steps.length > 0 && (
        <ol>
          {steps.map(({ code, copy }) => (
            <li key={code}>
              <p>{help.steps[code]}</p>
              {copy !== undefined && <CopyText text={copy} />}
            </li>
          ))}
        </ol>
      )}
      <p>
        <a href={ALL_STEPS} target="_blank" rel="noreferrer">
          {help.page}
        </a>
      </p>
    </>
  );
}

function stepsFor({ code, ...situation }: ConnectionHelpProps): readonly HelpStep[] {
  return helpFor(code, { ...situation, address: location.href });
}

/** The sentence about a failed connection. Without Web Serial it is about this browser. */
export function connectionSaid(code: ConnectionErrorCode, platform: Platform): Said {
  const { connection } = messages.value;
  const reason = code === 'unsupported' ? whyUnsupported(platform) : null;
  return reason ? unsupported[reason] : connection[code];
}

/** The help opens in the head of the page, which scrolls away while it is as long as this. It must stay in sight. */
function keepInSight(help: HTMLDetailsElement): void {
  const top = help.closest('.top');
  document.documentElement.toggleAttribute('data-help', help.open && top !== null);
  if (help.open) top?.scrollIntoView();
}
