import { render } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { ComparedPair } from '../../../src/app/compare/choice.js';
import { Compare } from '../../../src/app/compare/compare.js';
import { sideName } from '../../../src/app/compare/compare-page.js';
import { whole } from '../../../src/app/messages/dotted.js';
import { Print } from '../../../src/app/print/print.js';
import { PrintOrder } from '../../../src/app/print/print-order.js';
import type { ModelRecord } from '../../../src/app/storage/index.js';
import { BackupList } from '../../../src/app/write/backup-list.js';
import { en } from '../../tools/en.js';
import { BACKUP, LANCER_HELD, lancerConnected, S2, twoModels } from '../two-models.js';
import { idle, run, set } from './bench.js';

it('a value that is tried while the servos follow is nowhere as the timer holds it now, until it is read', async () => {
  const store = twoModels();
  // What the timer of the Lancer held: the same as now.
  store.backups.records.set(BACKUP.key, { ...BACKUP, program: LANCER_HELD, model: 'Lancer' });
  const bench = await lancerConnected(store);
  const { session } = bench;
  const record = session.library.models.get('Lancer') as ModelRecord;
  const backups = (): string => {
    const { container, unmount } = render(
      <BackupList {...{ session }} of={record} following={true} onLoad={() => {}} onCompare={() => {}} />,
    );
    const text = [...container.querySelectorAll('.kept-row')].at(-1)?.textContent ?? '';
    unmount();
    return text;
  };
  const side = (): string => {
    const timer = new Compare(session, new ComparedPair()).sides.value.find(({ kind }) => kind === 'timer');
    return timer ? sideName(session, timer).replaceAll('\u00a0', ' ') : '';
  };
  const sheet = () => new Print(session, new PrintOrder(), 'https://example.org/').sheets.value[0];
  const { modelBackups } = en;
  const same = whole(modelBackups.same({ when: modelBackups.now }));
  expect(backups()).toContain(same);

  session.safety.confirm();
  await run(bench.bench.moveTo(4));
  await run(bench.follow.start());
  set(bench, [S2, 77]);
  await idle();
  expect(bench.timer.core.content.positions[1]?.[4], 'it is in the timer').toBe(77);
  expect(backups()).not.toContain(same);
  expect(side()).toContain(en.knowledge.lastRead);
  const tried = sheet();
  expect(tried?.origin).toContain(en.bench.triedAndWaiting({ tried: 1, waiting: 0 }));
  expect(tried?.origin).not.toContain(en.knowledge.lastRead);
  expect([tried?.program.positions[1]?.[4], tried?.was(S2)]).toEqual([77, en.knowledge.marks.now({ value: '52' })]);
  expect(session.opened.source().from, 'nobody has read it').toBe('typed');

  await run(bench.follow.stop());
  expect(session.standing.value.sure).toBe('now');
  expect([backups().includes(same), backups()]).toEqual([
    false,
    expect.stringContaining(modelBackups.differs({ count: 1, when: modelBackups.now })),
  ]);
  expect(side()).not.toContain(en.knowledge.lastRead);
  expect(sheet()?.origin).toContain(en.knowledge.readAt({ time: '' }).trim());
});
