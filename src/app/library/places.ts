import type { ComponentChildren } from 'preact';
import type { ModelRecord, SettingRecord } from '../storage/index.js';

/** What other features put into the library. Each part has its place and order. */
export interface Places {
  /** Buttons below the list of models: for the library as a whole. */
  readonly library: ComponentChildren;
  /** Buttons on the page of a model. */
  readonly modelButtons: (record: ModelRecord) => ComponentChildren;
  /** Sections below its settings. */
  readonly modelSections: (record: ModelRecord) => ComponentChildren;
  /** Buttons on the page of a setting. @param model null when it belongs to none. */
  readonly settingButtons: (record: SettingRecord, model: ModelRecord | null) => ComponentChildren;
  /** Sections below its picture. */
  readonly settingSections: (record: SettingRecord, model: ModelRecord | null) => ComponentChildren;
}
