import type { ComponentChildren } from 'preact';
import { troubles as words } from '../messages/en-guide.js';
import './trouble-page.css';

export type Symptom = keyof typeof words.symptoms;
const SYMPTOMS = Object.keys(words.symptoms) as Symptom[];

/**
 * What to do, sorted by what a pilot sees.
 * @param connection the help about the connection, for symptoms that come from it.
 */
export function TroublePage({ connection }: { readonly connection: (symptom: Symptom) => ComponentChildren }) {
  return (
    <div class="stack trouble-page">
      {SYMPTOMS.map((symptom) => {
        const { title, steps } = words.symptoms[symptom];
        return (
          <details key={symptom} class="panel" name="symptom">
            <summary>{title}</summary>
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
