import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import './setting-line.css';

/** While a timer is connected: whose setting is open, and what of it is not saved. Without one, the strip says it. */
export function SettingLine({ session }: { readonly session: Session }) {
  const { knowledge: words } = messages.value;
  const { origin, opened, connection } = session;
  const changes = useComputed(() => opened.unsaved.value?.changes ?? 0).value;
  const setting = origin.setting.value;
  if (!connection.value || !setting) return null;
  const model = origin.model.value?.name;
  const name = model === undefined ? setting.name : words.ofModel({ name: setting.name, model });
  return <p class="hint setting-line">{words.ofSetting({ name, changes })}</p>;
}
