import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { decodeLink, differences, type Setting, type SharedSetting, sameKind } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { share } from '../../messages/en-share.js';
import { emptyModel, newId } from '../../session/library.js';
import type { Session } from '../../session/session.js';
import type { SettingRecord } from '../../storage/index.js';
import { NO_MODEL } from '../place.js';

/** In the place of a model's id: a setting that came goes under a new one. */
export const NEW_MODEL = 'new model';

/** Why a link says nothing. */
export type DamageCode = keyof typeof share.damaged.codes;

/** What became of it. */
export interface KeptSetting {
  readonly setting: Setting;
  /** Whether it would be there after a reload. */
  readonly isSaved: boolean;
}

/** A setting that came by link, as long as it is looked at. It goes nowhere by itself. */
export class Received {
  readonly #session: Session;
  /** Null where the link is damaged. */
  readonly shared: SharedSetting | null;
  readonly damage: DamageCode | null;
  readonly #place = signal<string | null>(null);
  readonly #kept = signal<KeptSetting | null>(null);
  readonly #keeping = signal(false);
  /** Where it would be kept: under the model of this name, if there is one. */
  readonly place: ReadonlySignal<string>;
  readonly kept: ReadonlySignal<KeptSetting | null> = this.#kept;
  /** It is on its way into the library. */
  readonly keeping: ReadonlySignal<boolean> = this.#keeping;
  /** A setting of the library that holds the same values under the same name; null if there is none. */
  readonly known: ReadonlySignal<SettingRecord | null>;

  constructor(session: Session, link: string) {
    this.#session = session;
    const { shared, damage } = read(link);
    this.shared = shared;
    this.damage = damage;
    const { models, settings } = session.library;
    this.place = computed(() => {
      const chosen = this.#place.value;
      if (chosen !== null) return chosen;
      const name = shared?.modelName ?? '';
      const [only, ...more] = models.list.value.filter(({ model }) => model.name === name && !model.archived);
      if (only && more.length === 0) return only.key;
      return name === '' || only ? NO_MODEL : NEW_MODEL;
    });
    this.known = computed(
      () =>
        settings.list.value.find(
          ({ key, setting }) =>
            shared !== null &&
            key !== this.#kept.value?.setting.id &&
            setting.name === shared.name &&
            sameKind(setting.program.identity, shared.program.identity) &&
            differences(setting.program, shared.program).length === 0,
        ) ?? null,
    );
  }

  choosePlace(place: string): void {
    this.#place.value = place;
  }

  /** Keeps it in the library, beside what is there. */
  async keep(): Promise<void> {
    const { shared } = this;
    if (!shared || this.#kept.peek() || this.#keeping.peek()) return;
    this.#keeping.value = true;
    const { library } = this.#session;
    const { modelName, ...values } = shared;
    const place = this.place.peek();
    const model = place === NEW_MODEL ? await this.#newModel(modelName) : place === NO_MODEL ? null : place;
    const setting: Setting = { ...values, id: newId(), model, from: 'link', archived: false };
    await library.keepSetting(setting);
    const isSaved =
      !library.settings.unsaved.peek().has(setting.id) && !(model !== null && library.models.unsaved.peek().has(model));
    this.#kept.value = { setting, isSaved };
    this.#keeping.value = false;
  }

  /** What it is as a setting: the one that was kept, or one that is in no library. */
  setting(): Setting | null {
    const { shared } = this;
    const kept = this.#kept.peek();
    if (kept || !shared) return kept?.setting ?? null;
    const { modelName: _, ...values } = shared;
    return { ...values, id: newId(), model: null, from: 'link', archived: false };
  }

  async #newModel(name: string): Promise<string> {
    const { identity } = (this.shared as SharedSetting).program;
    const id = newId();
    await this.#session.library.keepModel(emptyModel(id, name, identity.timerClass));
    return id;
  }
}

function read(link: string): { readonly shared: SharedSetting | null; readonly damage: DamageCode | null } {
  try {
    return { shared: decodeLink(link), damage: null };
  } catch (cause) {
    if (!(cause instanceof CodecError)) throw cause;
    const { code } = cause;
    return { shared: null, damage: code in share.damaged.codes ? (code as DamageCode) : 'other' };
  }
}
