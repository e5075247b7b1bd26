import { type FunctionComponent, h } from 'preact';
import { useMemo } from 'preact/hooks';

/**
 * A component that is drawn again only when one of its properties is another, or a signal that it reads. Of many rows
 * those stay as they are that have not changed. (preact/compat has one, and changes what events do in the whole page.)
 * @param keys the names of its properties.
 */
export function memo<Props extends object>(
  component: FunctionComponent<Props>,
  keys: readonly (keyof Props)[],
): FunctionComponent<Props> {
  return function Memo(props) {
    // The same node again is not looked into.
    return useMemo(
      () => h(component, props),
      keys.map((key) => props[key]),
    );
  };
}
