import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';
import { type Platform, whyUnsupported } from '../browser/platform.js';
import { messages, type Said } from '../messages/index.js';
import { type Link, portInfoOf } from '../timer/link.js';
import { CopyButton } from '../ui/copy-button.js';
import { type HelpCode, helpFor } from './connection-help.js';
import './connection-help-view.css';

interface ConnectionHelpProps {
  readonly code: HelpCode;
  readonly platform: Platform;
  readonly link: Pick<Link, 'state' | 'settings'>;
  /** The information of the port; null when none was chosen. Default: of the present one. */
  readonly info?: PortInfo | null;
}

/** The steps for every system: docs/connection.md, put there by the build. */
const ALL_STEPS = 'help/connection.html';

/** What to do, step by step, folded up under the notice. */
export function ConnectionHelp(props: ConnectionHelpProps) {
  if (stepsFor(props).length === 0) return null;
  return (
    <details
      key={props.code}
      class="help"
      // The head of the page scrolls while it is as long as this. It must stay in sight.
      onToggle={({ currentTarget }) => currentTarget.open && currentTarget.closest('.top')?.scrollIntoView()}
    >
      <summary>{messages.value.help.title}</summary>
      <HelpSteps {...props} />
    </details>
  );
}

/** What to do on this system, and a link to the steps for every other. */
export function HelpSteps(props: ConnectionHelpProps) {
  const { help, copy: label } = messages.value;
  const steps = stepsFor(props);
  return (
    <>
      {steps.length > 0 && (
        <ol class="stack gap-3">
          {steps.map(({ code, copy }) => (
            <li key={code}>
              <p>{help.steps[code]}</p>
              {copy !== undefined && (
                <p class="row">
                  <code>{copy}</code> <CopyButton label={label} text={() => copy} />
                </p>
              )}
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

function stepsFor({ code, platform, link, info = portInfoOf(link.state.value) }: ConnectionHelpProps) {
  const rateSet = typeof link.settings.value?.baudRate === 'number';
  return helpFor(code, { platform, info, rateSet, address: location.href });
}

/** The sentence about a failed connection. Without Web Serial it is about this browser. */
export function connectionSaid(code: ConnectionErrorCode, platform: Platform): Said {
  const { connection } = messages.value;
  const reason = code === 'unsupported' ? whyUnsupported(platform) : null;
  return reason ? messages.value.unsupported[reason] : connection[code];
}
