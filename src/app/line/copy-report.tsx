import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { CopyButton } from '../ui/copy-button.js';
import { gatherFacts, reportText } from './report.js';

/** Copies a report with everything that a maintainer needs to know. */
export function CopyReport({ session }: { readonly session: Session }) {
  return <CopyButton label={messages.value.report.copy} text={() => reportText(gatherFacts(session))} />;
}
