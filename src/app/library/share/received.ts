import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { decodeLink, differences, type Setting, type SharedSetting, sameKind } from '../../../program/index.js';
import { CodecError } from '../../../protocol/index.js';
import { emptyModel, newId } from '../../session/library.js';
import { plainName, withPlainNames } from '../../session/plain-names.js';
import type { Session } from '../../session/session.js';
import type { SettingRecord } from '../../storage/index.js';
import { NO_MODEL } from '../place.js';

/** Stands in place of a model's id: the received setting goes under a new model. */
export const NEW_MODEL = 'new model';

/** How it was kept. */
export interface KeptSetting {
  readonly setting: Setting;
  /** Whether it would still be there after a reload. */
  readonly isSaved: boolean;
}

/** A setting that came by link, while the pilot looks at it. It is not kept until the pilot says so. */
export class Received {
  readonly #session: Session;
  /** Null when the link is damaged. */
  readonly shared: SharedSetting | null;
  /** Whether a newer version of the page made a link that this one cannot read. */
  readonly isNewer: boolean;
  readonly #place = signal<string | null>(null);
  readonly #kept = signal<KeptSetting | null>(null);
  readonly #keeping = signal(false);
  /** Where it would be kept: under the model of this name, if there is one. */
  readonly place: ReadonlySignal<string>;
  readonly kept: ReadonlySignal<KeptSetting | null> = this.#kept;
  /** Whether it is being saved. */
  readonly keeping: ReadonlySignal<boolean> = this.#keeping;
  /** A setting of the library with the same name and values; null for none. */
  readonly known: ReadonlySignal<SettingRecord | null>;

  constructor(session: Session, link: string) {
    this.#session = session;
    const { shared, isNewer } = read(link);
    this.shared = shared;
    this.isNewer = isNewer;
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

  /** Keeps it in the library, beside everything that is there. */
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

  /** The kept setting; before that, one that is in no library. */
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

function read(link: string): { readonly shared: SharedSetting | null; readonly isNewer: boolean } {
  try {
    return { shared: plain(decodeLink(link)), isNewer: false };
  } catch (cause) {
    if (!(cause instanceof CodecError)) throw cause;
    return { shared: null, isNewer: cause.code === 'newer-version' };
  }
}

/** As it would be kept: it is shown in sentences, and compared with what is there. */
function plain({ modelName, ...values }: SharedSetting): SharedSetting {
  const setting = withPlainNames<Setting>({ ...values, id: 'link', model: null, from: 'link', archived: false });
  const { name, note, tags, at, program } = setting;
  return { name, note, tags, at, program, modelName: plainName(modelName) };
}
