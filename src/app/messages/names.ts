import type { Identity } from '../../protocol/index.js';
import type { KnownPort } from '../../serial/index.js';
import { whole } from './dotted.js';
import { moreMessages } from './more.js';
import { messages } from './page.js';
import type { MoreSentences, PageSentences } from './sentences.js';

/** “M1”. @param memory counted from 0. */
export function memoryName(memory: number): string {
  return messages.value.memoryName({ number: memory + 1 });
}

/** “S1”. @param servo counted from 0. */
export function servoName(servo: number): string {
  return messages.value.servoName({ number: servo + 1 });
}

/** What a servo moves: the pilot's name for it, or the name of its duty. */
export function dutyName({ duty, name }: { duty: keyof MoreSentences['preview']['duties']; name: string }): string {
  return name || moreMessages.value.preview.duties[duty];
}

/** A servo, with what it moves if the pilot has said that: “S1 Tailplane”. */
export function servoText(servo: number, use: Parameters<typeof dutyName>[0] | undefined): string {
  return use ? `${servoName(servo)} ${dutyName(use)}` : servoName(servo);
}

/** “2 models, 1 program”: only kinds that there are. */
export function countedText(counts: Partial<Readonly<Record<keyof PageSentences['counted'], number>>>): string {
  const { counted } = messages.value;
  const { models = 0, settings = 0, flights = 0, backups = 0 } = counts;
  return [
    models > 0 && counted.models({ count: models }),
    settings > 0 && counted.settings({ count: settings }),
    flights > 0 && counted.flights({ count: flights }),
    backups > 0 && counted.backups({ count: backups }),
  ]
    .filter(Boolean)
    .join(', ');
}

export function timerName({ timerClass }: Pick<Identity, 'timerClass'>): string {
  const { classNames, unknownClass } = messages.value;
  const known: Readonly<Record<string, string>> = classNames;
  return known[timerClass] ?? unknownClass({ letter: timerClass });
}

/** “FTDI adapter”, “USB adapter 1234:5678”. */
export function portName({ kind, info }: Pick<KnownPort, 'kind' | 'info'>): string {
  const { portNames } = messages.value.link;
  if (kind !== 'usb') return portNames[kind];
  const hex = (value: number | undefined): string => (value ?? 0).toString(16).padStart(4, '0');
  return `${portNames.usb} ${hex(info.usbVendorId)}:${hex(info.usbProductId)}`;
}

/** “F1Q, firmware 536, 9 functions, 3 servos”. A program that was made here has no firmware. */
export function timerText(identity: Identity): string {
  const { header, timeline } = messages.value;
  const { firmware, functions, servos } = identity;
  return [
    timerName(identity),
    firmware === '000' ? null : whole(header.firmware({ firmware })),
    whole(timeline.functions({ count: functions - 1 })),
    whole(timeline.servos({ count: servos })),
  ]
    .filter(Boolean)
    .join(', ');
}

/** A program of the library: “calm of Lancer 07”. @param model empty for none. */
export function programOf(name: string, model: string): string {
  return model === '' ? name : messages.value.knowledge.ofModel({ name, model });
}
