import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { CopyButton } from '../ui/copy-button.js';
import { gatherFacts, reportText } from './report.js';

/** Copies what a maintainer needs to know. */
export function CopyReport() {
  const { session } = useModels();
  return <CopyButton label={messages.value.report.copy} text={() => reportText(gatherFacts(session))} />;
}
