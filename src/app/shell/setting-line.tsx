import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { useLateComputed } from '../ui/use-late.js';
import './setting-line.css';

/** While a timer is connected: whose setting is open, and what of it is not saved. Without one, the strip says it. */
export function SettingLine({ session }: { readonly session: Session }) {
  const { knowledge: words } = messages.value;
  const { editor, origin, opened, connection } = session;
  const of = useComputed(() => [editor.baseline.value, origin.setting.value]);
  // After the field that was typed into.
  const changes = useLateComputed(() => opened.unsaved.value?.changes ?? 0, of);
  const setting = origin.setting.value;
  if (!connection.value || !setting) return null;
  const model = origin.model.value?.name;
  const name = model === undefined ? setting.name : words.ofModel(setting.name, model);
  return <p class="hint setting-line">{words.ofSetting(name, changes)}</p>;
}
