import { messages } from '../messages/index.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { DENSITIES, type Density } from './density.js';

/** Chooses the height of the program's rows. */
export function DensityChoice({ density }: { readonly density: Density }) {
  const { title, names } = messages.value.density;
  return (
    <SegmentChoice
      {...{ title, names }}
      name="density"
      choices={DENSITIES}
      chosen={density.chosen.value}
      onChoose={(name) => density.choose(name)}
    />
  );
}
