import { messages } from '../messages/index.js';
import type { Theme } from './theme.js';
import { THEMES } from './theme.js';
import './theme-choice.css';

/** How the page looks, one tap each: whoever stands in the sun cannot read a menu. */
export function ThemeChoice({ theme }: { readonly theme: Theme }) {
  const { title, names } = messages.value.theme;
  return (
    <fieldset class="theme">
      <legend>{title}</legend>
      <div class="segments">
        {THEMES.map((name) => (
          <label key={name}>
            <input
              type="radio"
              name="theme"
              class="visually-hidden"
              checked={name === theme.chosen.value}
              onChange={() => theme.choose(name)}
            />
            <span>{names[name]}</span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
