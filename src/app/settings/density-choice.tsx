import { messages } from '../messages/index.js';
import { DENSITIES, type Density } from './density.js';
import { SegmentChoice } from './segment-choice.js';

/** How high the rows of the program are. */
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
