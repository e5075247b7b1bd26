import type { ComponentChildren } from 'preact';
import { moreMessages } from '../messages/more.js';
import type { MoreSentences } from '../messages/sentences.js';
import './trouble-page.css';

export type Symptom = keyof MoreSentences['troubles']['symptoms'];

/**
 * What to do, sorted by what a pilot sees.
 * @param connection the help about the connection, for symptoms that come from it.
 */
export function TroublePage({ connection }: { readonly connection: (symptom: Symptom) => ComponentChildren }) {
  const { symptoms } = moreMessages.value.troubles;
  return (
    <div class="stack trouble-page">
      {(Object.keys(symptoms) as Symptom[]).map((symptom) => {
        const said = symptoms[symptom];
        const steps = 'steps' in said ? Object.values(said.steps) : [];
        return (
          <details key={symptom} class="panel" name="symptom">
            <summary>{said.title}</summary>
            {steps.length > 0 && (
              <ol class="stack">
                {steps.map((step) => (
                  <li key={step}>{step}</li>
                ))}
              </ol>
            )}
            {connection(symptom)}
          </details>
        );
      })}
    </div>
  );
}
