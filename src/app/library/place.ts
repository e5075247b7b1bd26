/**
 * A place in the library. In the address, after `#library/`:
 * - nothing: all models
 * - `ID`: a model
 * - `ID/ID`: a model and one of its settings
 * - `none`, `none/ID`: the settings that belong to no model
 *
 * A file may bring an id that equals such a word, or the address of the flights. A `/` before it tells them apart.
 */
export interface LibraryPlace {
  /** `NO_MODEL` for the settings without a model; null when none is chosen. */
  readonly model: string | null;
  readonly setting: string | null;
}

/** Stands in place of a model's id, and can be no id itself. */
export const NO_MODEL = ' none';
const NONE = 'none';

export function placeOf(path: string): LibraryPlace {
  const isId = path.startsWith('/');
  const [model = '', setting = ''] = (isId ? path.slice(1) : path).split('/');
  return { model: !isId && model === NONE ? NO_MODEL : model || null, setting: setting || null };
}

/** The place of a model, or of one of the settings. */
export function addressPath(model: string | null, setting: string | null = null): string {
  const isNone = model === null || model === NO_MODEL;
  const place = isNone ? NONE : /^[a-z]+$/.test(model) ? `/${model}` : model;
  return [place, setting].filter(Boolean).join('/');
}

/** The address of a model, or of one of the settings. */
export function addressOf(model: string | null, setting: string | null = null): `#${string}` {
  return `#library/${addressPath(model, setting)}`;
}
