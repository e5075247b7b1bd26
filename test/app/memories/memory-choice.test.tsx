import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import type { TimerProgram } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { idle, run, selected } from '../bench/bench.js';
import { button, connected, field, fly, lookAt, press, strandAtM3, type } from '../screen.js';

/** What is read aloud of each memory, and which of them is shown. */
function choices(): string[] {
  const radios = within(screen.getByRole('group', { name: 'Memory' })).getAllByRole<HTMLInputElement>('radio');
  return radios.map((radio) => `${radio.checked ? '* ' : ''}${radio.getAttribute('aria-label')}`);
}

const said = () => [...document.querySelectorAll('.unfinished strong')].map(({ textContent }) => textContent);
const dialog = () => within(screen.getByRole('dialog', { name: en.nextFlight.leaving.title }));

describe('the memories', () => {
  it.each([8, 9, 255])('of a timer that has %i are in one line, by a tap or in a list', async (memories) => {
    const { timer } = await connected({ identity: { timerClass: 'Q', memories } });
    const list = screen.queryByRole<HTMLSelectElement>('combobox', { name: en.program.memory });
    expect(screen.queryAllByRole('radio')).toHaveLength(memories === 8 ? 8 : 0);
    if (memories === 8) return;
    expect([...(list?.options ?? [])].slice(0, 2).map(({ text }) => text)).toEqual([
      en.nextFlight.named({ memory: en.memoryName({ number: 1 }) }),
      en.memoryName({ number: 2 }),
    ]);
    expect([list?.options.length, list?.value]).toEqual([memories, '0']);
    timer.core.answered.length = 0;
    fireEvent.change(list as HTMLSelectElement, { target: { value: '8' } });
    await idle();
    expect(screen.getByRole('heading', { name: /^M9 has not been read/ })).toBeTruthy();
    expect([list?.value, timer.core.answered], 'it is only shown').toEqual(['8', []]);
  });

  it('are only shown by a tap: the one that flies next is marked, and nothing is sent', async () => {
    const { timer } = await connected();
    const asked = timer.core.answered.length;
    expect(choices()).toEqual(['* M1, flies next', 'M2', 'M3', 'M4']);
    await lookAt('M3');
    await idle();
    expect(choices()).toEqual(['M1, flies next', 'M2', '* M3', 'M4']);
    expect(screen.getByRole('heading', { name: 'M3 has not been read' })).toBeTruthy();
    expect(screen.queryByRole('textbox', { name: 'DT time' }), 'it is not read yet').toBeNull();
    expect(screen.queryByRole('button', { name: /^Write/ })).toBeNull();
    expect([timer.core.answered.length - asked, timer.core.memory]).toEqual([0, 0]);
    await lookAt('M1, flies next');
    expect(field('DT time').value).toBe('3:00');
  });

  it('are shown as last read, with the time and nothing to type into', async () => {
    const app = await connected();
    await run(app.memories.readOnce(2));
    await lookAt('M3');
    expect(screen.getByRole('heading', { name: /^M3, read \d+:\d\d/ })).toBeTruthy();
    const held = within(screen.getByRole('table', { name: en.program.tableCaption }));
    const row = held.getByRole('rowheader', { name: en.program.dt }).parentElement;
    expect([...(row?.children ?? [])].map(({ textContent }) => textContent)[1]).toBe('4:00 min');
    expect(held.queryAllByRole('textbox')).toEqual([]);
    expect(choices()).toEqual(['M1, flies next', 'M2', '* M3', 'M4']);
    await press('Show M1');
    expect(field('DT time').value).toBe('3:00');
  });

  it('take no typing into the old one while another is read', async () => {
    const { session } = await connected();
    const parts = [field('DT time'), field('Function 2, S1'), screen.getByRole('group', { name: /^Servo positions/ })];
    const isShut = () => parts.map((part) => part.closest('[inert]') !== null);
    const selecting = session.reader.selectMemory(2);
    await idle(0);
    expect(isShut()).toEqual([true, true, true]);
    await run(selecting);
    await idle();
    expect(isShut()).toEqual([false, false, false]);
  });

  it('fly next when they are made to, which a calm line says until the first one flies next again', async () => {
    const { timer } = await connected();
    await type('DT time', '5:00');
    await fly('M3');
    expect([timer.core.memory, choices()]).toEqual([2, ['M1', 'M2', '* M3, flies next', 'M4']]);
    expect(field('DT time').value).toBe('4:00');
    const line = `${en.nextFlight.other({ memory: 'M3' })} ${en.nextFlight.original({ original: 'M1' })}`;
    expect(screen.getByText(line).className).toBe('hint');
    expect([
      screen.queryByRole('alert'),
      screen.queryByRole('button', { name: en.nextFlight.back({ original: 'M1' }) }),
    ]).toEqual([null, null]);
    await fly('M1');
    expect([timer.core.memory, choices()]).toEqual([0, ['* M1, flies next', 'M2', 'M3', 'M4']]);
    expect(screen.queryByText(/flies next\./)).toBeNull();
    expect(field('DT time').value, 'the edits of M1 are still there').toBe('5:00');
  });

  it('show none while it is not known whether the selection worked, then the current one', async () => {
    const { timer } = await connected();
    await lookAt('M3');
    timer.core.sleep();
    await press('Make M3 fly next');
    expect(choices()).toEqual(['M1', 'M2', 'M3', 'M4']);
    expect(screen.getByText(/^No answer for \d+ s\./)).toBeTruthy();
    expect(document.querySelector('.unfinished')?.textContent).toContain(
      en.recovery.mayFly({ memory: 'M3 of the F1Q 536' }),
    );
    timer.core.press();
    await idle();
    expect([timer.core.memory, choices()]).toEqual([0, ['* M1, flies next', 'M2', 'M3', 'M4']]);
    expect(screen.queryByRole('alert')).toBeNull();
  });

  it('can all be chosen again after a failure that leaves the current one unknown', async () => {
    const { timer, session } = await connected();
    session.nextFlight.doubt();
    await idle(0);
    expect(choices()).toEqual(['M1', 'M2', 'M3', 'M4']);
    expect(screen.getByText(/^It is not known which memory flies next/)).toBeTruthy();
    timer.core.memory = 2;
    await fly('M1');
    expect([timer.core.memory, choices()]).toEqual([0, ['* M1, flies next', 'M2', 'M3', 'M4']]);
  });

  it('say when the timer does not tell the current one, and that none can be looked at then', async () => {
    const { timer } = await connected({ quirks: { memoryReplyEmpty: true } });
    expect(screen.getByText(/^This timer does not say which memory is current/)).toBeTruthy();
    expect(choices()).toEqual(['M1', 'M2', 'M3', 'M4']);
    await lookAt('M2');
    expect(button('Edit M2').disabled).toBe(true);
    await press('Make M2 fly next');
    expect(timer.core.memory).toBe(1);
    expect(said()).toEqual([
      'It is not known which memory flies next. M2 was selected last. It is not known which one it was when you connected.',
    ]);
  });

  it('say that they are uncertain after a write into one was cut off', async () => {
    const { session } = await connected();
    const before = { ...(session.editor.baseline.value as TimerProgram), memory: 2 };
    const times = before.times.map((time, slot) => (slot === 10 ? 36_000 : time));
    await session.knowledge.begin(before, { ...before, times });
    session.knowledge.jobOver();
    await lookAt('M3');
    expect(screen.getByRole('heading', { name: en.knowledge.unknown({ memory: 'M3' }) })).toBeTruthy();
    const row = screen.getByRole('rowheader', { name: 'DT' }).parentElement;
    expect([...(row?.children ?? [])].map(({ textContent }) => textContent)).toEqual(['DT', '3:00 min', '6:00 min']);
  });
});

it('a look that cannot go back is reported at once, with the way back', async () => {
  const app = await connected();
  await lookAt('M3');
  let away = 0;
  app.timer.core.onAnswer = ({ name }) => {
    if (name !== 'GETSERVOPOS' || app.timer.core.memory !== 2) return;
    // It does not hear the way back, nor what is asked after that.
    away++;
    app.timer.core.sleep();
  };
  await press('Edit M3');
  expect([away > 0, app.timer.core.memory]).toEqual([true, 2]);
  expect(app.session.notices.current.value).toEqual({ kind: 'timer', code: 'memory-left' });
  expect(document.querySelector('.unfinished')?.textContent).toContain(
    en.recovery.mayFly({ memory: 'M3 of the F1Q 536' }),
  );
  app.timer.core.onAnswer = undefined;
  app.timer.core.press();
  await idle();
  expect(choices()).toEqual(['M1', 'M2', '* M3, flies next', 'M4']);
  await press('Make M1 fly next');
  expect([app.timer.core.memory, choices()]).toEqual([0, ['* M1, flies next', 'M2', 'M3', 'M4']]);
  expect(screen.queryByRole('alert')).toBeNull();
});

describe('Disconnect', () => {
  it('asks nothing while the memory from the connection flies next', async () => {
    const app = await connected();
    await lookAt('M3');
    await press('Edit M3');
    await press('Disconnect');
    expect([app.session.link.state.value.status, screen.queryByRole('dialog')]).toEqual(['off', null]);
  });

  it('asks nothing about a memory that the pilot has made fly next', async () => {
    const app = await connected();
    await fly('M3');
    await press('Disconnect');
    expect([app.session.link.state.value.status, screen.queryByRole('dialog'), app.timer.core.memory]).toEqual([
      'off',
      null,
      2,
    ]);
  });

  it('says that another memory flies next than was meant, and goes back on a click', async () => {
    const app = await connected();
    await strandAtM3(app);
    await press('Disconnect');
    expect(dialog().getByRole('status').textContent).toBe(
      `${en.nextFlight.other({ memory: 'M3' })} ${en.nextFlight.original({ original: 'M1' })}`,
    );
    expect(app.session.link.state.value.status).toBe('on');
    await press('Back to M1 and disconnect');
    expect([app.session.link.state.value.status, app.timer.core.memory]).toEqual(['off', 0]);
    expect(screen.queryByRole('dialog')).toBeNull();
  });

  it('goes back to the memory that the pilot has chosen, not to that of connecting', async () => {
    const app = await connected();
    await fly('M2');
    await strandAtM3(app);
    await press('Disconnect');
    await press('Back to M2 and disconnect');
    expect([app.session.link.state.value.status, app.timer.core.memory]).toEqual(['off', 1]);
  });

  it('leaves the choice to the pilot', async () => {
    const app = await connected();
    await strandAtM3(app);
    await press('Disconnect');
    await press('Cancel');
    expect([app.session.link.state.value.status, screen.queryByRole('dialog')]).toEqual(['on', null]);
    await press('Disconnect');
    dialog().getByRole('button', { name: 'Disconnect' }).click();
    await idle();
    expect([app.session.link.state.value.status, app.timer.core.memory]).toEqual(['off', 2]);
  });

  it('stays when the way back fails, and says so', async () => {
    const app = await connected();
    await strandAtM3(app);
    await press('Disconnect');
    app.timer.core.sleep();
    await press('Back to M1 and disconnect');
    expect(dialog().getByRole('alert').textContent).toContain('The timer did not go back to M1.');
    expect(dialog().getByRole('status').textContent).toContain(en.nextFlight.unknown);
    app.timer.core.press();
    await idle();
    expect(dialog().getByRole('status').textContent).toBe(
      `${en.nextFlight.other({ memory: 'M3' })} ${en.nextFlight.original({ original: 'M1' })}`,
    );
    await press('Back to M1 and disconnect');
    expect([app.session.link.state.value.status, app.timer.core.memory]).toEqual(['off', 0]);
  });

  it('during a look goes back first and closes the port then', async () => {
    const app = await connected();
    await lookAt('M3');
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'GETTIMERS' && app.timer.core.memory === 2) button('Disconnect').click();
    };
    await press('Edit M3');
    expect([app.session.link.state.value.status, app.timer.core.memory, selected(app)]).toEqual(['off', 0, [2, 0]]);
  });

  it('during a look that no answer ends, Stop says that it first goes back, and Disconnect does not wait', async () => {
    const app = await connected();
    await lookAt('M3');
    app.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETMEMORY') app.timer.core.sleep();
    };
    fireEvent.click(button('Edit M3'));
    await idle(5000);
    expect(screen.queryByText(en.write.stoppingBack)).toBeNull();
    fireEvent.click(button('Stop'));
    await idle(0);
    expect(screen.getByText(en.write.stoppingBack).textContent).toContain('first back');
    expect(button('Stop').getAttribute('aria-disabled')).toBe('true');
    fireEvent.click(button('Disconnect'));
    await idle(0);
    fireEvent.click(dialog().getByRole('button', { name: 'Disconnect' }));
    await idle(1000);
    expect(app.session.link.state.value.status).toBe('off');
  });

  it('says after a selection that the current memory is not known, if the timer does not say it', async () => {
    const app = await connected({ quirks: { memoryReplyEmpty: true } });
    await fly('M2');
    await press('Disconnect');
    expect(dialog().getByRole('status').textContent).toBe(
      'It is not known which memory flies next. M2 was selected last. It is not known which one it was when you connected.',
    );
    expect(dialog().queryByRole('button', { name: /^Back to/ })).toBeNull();
    dialog().getByRole('button', { name: 'Disconnect' }).click();
    await idle();
    expect(app.session.link.state.value.status).toBe('off');
    await press('Connect');
    await press('Disconnect');
    expect(
      app.session.link.state.value.status,
      'no memory was selected on this connection, so there is no question',
    ).toBe('off');
  });
});
