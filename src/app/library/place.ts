/**
 * Where one is in the library, as it stands in the address after `#library/`:
 *
 * - nothing: all models
 * - `ID`: a model
 * - `ID/ID`: a model and one of its settings
 * - `none`, `none/ID`: the settings that belong to no model
 */
export interface LibraryPlace {
  /** `NO_MODEL` for the settings that belong to none; null where none is chosen. */
  readonly model: string | null;
  readonly setting: string | null;
}

/** In the place of a model's id. */
export const NO_MODEL = 'none';

export function placeOf(path: string): LibraryPlace {
  const [model = '', setting = ''] = path.split('/');
  return { model: model || null, setting: setting || null };
}

/** The place of a model, or of one of the settings. */
export function addressPath(model: string | null, setting: string | null = null): string {
  return [model ?? NO_MODEL, setting].filter(Boolean).join('/');
}

/** The address of a model, or of one of the settings. */
export function addressOf(model: string | null, setting: string | null = null): string {
  return `#library/${addressPath(model, setting)}`;
}
