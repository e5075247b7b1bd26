import { options, type VNode } from 'preact';

/** What Preact notes in a node of a component, by the names that it has in every build. */
interface Drawn extends VNode {
  /** What the component has drawn. */
  __k: readonly unknown[] | null;
  /** The component, with the node of its last drawing. */
  __c?: { lastDrawn?: Drawn } | null;
}

const { diffed } = options;

/**
 * From now on a component lets go of its drawing once it has a newer one.
 *
 * Preact does not: the node of the old drawing still leads to what was in it and stays, and that to the next drawing.
 * Where components are drawn by turns, as with signals, that never ends. One old node that something holds, such as the
 * children that a component got when it was made, then holds every drawing since: one drag of a mark left 2,900 objects
 * behind. Seen with Preact 11.2; issue 4909 of preactjs/preact is of this kind.
 */
options.diffed = (node: VNode): void => {
  diffed?.(node);
  const drawn = node as Drawn;
  const { __c: component } = drawn;
  if (!component) return;
  const { lastDrawn } = component;
  component.lastDrawn = drawn;
  if (lastDrawn && lastDrawn !== drawn) lastDrawn.__k = null;
};
