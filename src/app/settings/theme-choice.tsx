import { messages } from '../messages/index.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { THEMES, type Theme } from './theme.js';

/** Chooses the colours of the page. */
export function ThemeChoice({ theme }: { readonly theme: Theme }) {
  const { title, names } = messages.value.theme;
  return (
    <SegmentChoice
      {...{ title, names }}
      name="theme"
      choices={THEMES}
      chosen={theme.chosen.value}
      onChoose={(name) => theme.choose(name)}
    />
  );
}
