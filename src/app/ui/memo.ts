import { type FunctionComponent, h } from 'preact';
import { useMemo } from 'preact/hooks';

/**
 * A component that is drawn again only when one of its properties has changed, or a signal that it reads. Unchanged
 * rows of a long table stay as they are. (preact/compat has one, but changes how events work in the whole page.)
 */
export function memo<Props extends object>(component: FunctionComponent<Props>): FunctionComponent<Props> {
  return function Memo(props) {
    // Preact does not look into the same node again.
    return useMemo(() => h(component, props), Object.values(props));
  };
}
