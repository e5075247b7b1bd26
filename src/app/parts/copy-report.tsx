import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { gatherFacts, reportText } from '../state/report.js';
import { CopyButton } from './copy-button.js';

/** Copies what a maintainer needs to know. */
export function CopyReport() {
  const { session } = useModels();
  return <CopyButton label={messages.value.report.copy} text={() => reportText(gatherFacts(session))} />;
}
