import { describe, expect, it } from 'vitest';
import { FrameForm } from '../../../src/app/line/frame-form.js';
import { toHex } from '../../tools/bytes.js';
import { connectedBench, idle, run } from '../bench/bench.js';

/** A pilot before the form, connected to a timer. */
async function atForm() {
  const bench = await connectedBench();
  const { answered } = bench.timer.core;
  answered.length = 0;
  return { ...bench, form: new FrameForm(bench.session), asked: () => answered.map(({ name }) => name) };
}

const READ_ALL = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER'];

describe('a frame by hand', () => {
  it('has its length, checksum and end filled in', async () => {
    const { form } = await atForm();
    expect(toHex(form.bytes.value as Uint8Array)).toBe('00 00 00 00 00 03 6b 6b 45');
    form.edit({ command: 'SETSERVO', data: '04 01 46' });
    expect(toHex(form.bytes.value as Uint8Array)).toBe('00 00 00 00 00 06 63 04 01 46 ae 45');
    form.edit({ command: null, letter: '0x79', data: '' });
    expect(toHex(form.bytes.value as Uint8Array)).toBe('00 00 00 00 00 03 79 79 45');
  });

  it.each([
    ['', 0],
    ['  ', 0],
    ['0F', 1],
    ['0f1e', 2],
    ['0f, 1e', 2],
    ['0x0f 0X1E', 2],
    ['0f\n1e', 2],
    ['00'.repeat(252), 252],
  ])('takes data %j', async (data, bytes) => {
    const { form } = await atForm();
    form.edit({ data });
    expect(form.dataFault.value).toBeNull();
    expect(form.frame.value?.data).toHaveLength(bytes);
  });

  it.each([
    ['0', 'odd-digits'],
    ['0f 1', 'odd-digits'],
    ['0 f', 'odd-digits'],
    ['0g', 'not-hex'],
    ['hello', 'not-hex'],
    ['-1', 'not-hex'],
    ['0x', 'not-hex'],
    ['00'.repeat(253), 'too-long'],
  ])('refuses data %j: %s', async (data, fault) => {
    const { form, asked } = await atForm();
    form.edit({ data });
    expect(form.dataFault.value).toBe(fault);
    expect([form.frame.value, form.bytes.value, form.ready.value]).toEqual([null, null, false]);
    await form.send();
    await idle();
    expect(asked()).toEqual([]);
  });

  it.each(['', '7', 'zz', '123', '79 79'])('refuses the letter %j', async (letter) => {
    const { form } = await atForm();
    form.edit({ command: null, letter });
    expect(form.letterFault.value).toBe('not-a-byte');
    expect(form.frame.value).toBeNull();
  });

  it('is sent at once when it only reads, and shows its reply', async () => {
    const { form, asked } = await atForm();
    form.edit({ command: 'GETMEMORY' });
    await run(form.send());
    expect(form.result.value?.reply).toEqual({ code: 0x72, data: Uint8Array.of(0) });
    expect(asked(), 'nothing else is sent to the timer').toEqual(['GETMEMORY']);
  });

  it.each([
    ['SETLOWRPM', '05', 'stores'],
    ['SETMEMORY', '01', 'stores'],
    ['MOVETOFUNC', '04', 'moves'],
    ['UNLOCK', '', 'frees-motor'],
    ['JUMP2', '', 'unknown'],
  ] as const)('needs a second click and is sent once: %s', async (command, data, effect) => {
    const { form, asked } = await atForm();
    form.edit({ command, data });
    expect(form.effect.value).toBe(effect);
    await form.send();
    await form.send();
    await idle();
    expect(form.step.value).toBe('confirm');
    expect(asked(), 'nothing is sent before the pilot confirms it').toEqual([]);
    const sending = form.confirm();
    await form.confirm();
    await form.send();
    await run(sending);
    await form.confirm();
    await idle();
    expect(asked().filter((name) => name === command)).toHaveLength(1);
    expect(form.step.value).toBe('edit');
    const screenMayBeOld = effect === 'stores' || effect === 'unknown';
    expect(asked()).toEqual(screenMayBeOld ? [command, ...READ_ALL] : [command]);
  });

  it('occupies the line as any other job does', async () => {
    const { form, session, timer, asked } = await atForm();
    timer.core.sleep();
    form.edit({ command: 'GETMEMORY' });
    const sending = form.send();
    expect([form.step.value, session.runner.job.value?.kind, session.runner.busy.value]).toEqual([
      'sending',
      'frame',
      true,
    ]);
    form.edit({ command: 'GETTIMERS' });
    expect([await session.reader.read(), asked()], 'nothing else is sent meanwhile').toEqual([false, []]);
    await run(sending);
    expect([form.command.value, form.step.value, session.runner.busy.value]).toEqual(['GETMEMORY', 'edit', false]);
  });

  it('shows what the timer holds once it was changed', async () => {
    const { form, editor } = await atForm();
    form.edit({ command: 'SETSERVO', data: '04 01 46' });
    await form.send();
    await run(form.confirm());
    expect(editor.baseline.value?.positions[1]?.[4]).toBe(70);
  });

  it('that selects a memory makes it unknown which one flies next, until the timer says it', async () => {
    const { form, session, timer } = await atForm();
    form.edit({ command: 'SETMEMORY', data: '02' });
    await form.send();
    timer.core.onAnswer = ({ name }) => {
      if (name === 'SETMEMORY') timer.core.sleep();
    };
    await run(form.confirm());
    expect(session.nextFlight.word.value).toEqual({ code: 'unknown', asked: null, original: 0 });
    timer.core.onAnswer = undefined;
    timer.core.press();
    await idle();
    await run(session.reader.read());
    expect(session.nextFlight.word.value).toEqual({ code: 'other', memory: 2, original: 0 });
  });

  it('may do anything when its letter is not in the table of requests, or when a question carries data', async () => {
    const { form } = await atForm();
    for (const letter of ['79', '62', '00', 'ff']) {
      form.edit({ command: null, letter, data: '' });
      expect(form.effect.value).toBe('unknown');
    }
    form.edit({ command: null, letter: '6b' });
    expect(form.effect.value).toBe('reads');
    form.edit({ data: '01' });
    expect(form.effect.value).toBe('unknown');
  });

  it('is no longer waiting for a yes when it is changed, cancelled, or the connection is new', async () => {
    const { form, session, asked } = await atForm();
    const ask = async (): Promise<void> => {
      form.edit({ command: 'UNLOCK', data: '' });
      await form.send();
      expect(form.step.value).toBe('confirm');
    };
    await ask();
    form.edit({ command: 'MOVETOFUNC', data: '00' });
    await form.confirm();
    await ask();
    form.cancel();
    await form.confirm();
    await ask();
    await run(session.timer.disconnect());
    await form.confirm();
    await run(session.timer.connect());
    expect(form.step.value).toBe('edit');
    await form.confirm();
    await idle();
    expect(asked().filter((name) => name === 'UNLOCK' || name === 'MOVETOFUNC')).toEqual([]);
  });

  it('says when no reply came, and still reads what the timer holds', async () => {
    const { form, asked } = await atForm();
    form.edit({ command: null, letter: '79', data: '' });
    await form.send();
    await run(form.confirm());
    expect(form.result.value).toEqual({ reply: null });
    expect(asked().slice(-READ_ALL.length)).toEqual(READ_ALL);
  });

  it('cannot be sent without a connection, or while something else is on the wire', async () => {
    const { form, session, asked } = await atForm();
    const reading = session.reader.read();
    expect(form.ready.value).toBe(false);
    await run(reading);
    expect(form.ready.value).toBe(true);
    await run(session.timer.disconnect());
    expect(form.ready.value).toBe(false);
    asked().length = 0;
    await form.send();
    expect(form.step.value).toBe('edit');
  });

  it('is not sent any more when the pilot stops it while the line is waited for', async () => {
    const { form, session, timer, asked } = await atForm();
    timer.core.sleep();
    form.edit({ command: 'GETTIMERS' });
    await run(form.send());
    form.edit({ command: 'UNLOCK' });
    await form.send();
    // An answer to the request before may still come, so this one waits.
    const sending = form.confirm();
    await idle(200);
    timer.core.press();
    void session.runner.stop();
    await run(sending);
    await idle();
    expect(asked()).not.toContain('UNLOCK');
    expect([form.step.value, form.result.value]).toEqual(['edit', null]);
  });

  it('does not itself report that the port is lost', async () => {
    const { form, adapter, session } = await atForm();
    form.edit({ command: 'GETTIMERS' });
    const sending = form.send();
    adapter.unplug();
    await run(sending);
    expect(session.connection.value).toBeNull();
    expect(session.notices.current.value?.kind, 'there is no notice about the frame').not.toBe('timer');
    expect([form.step.value, form.result.value]).toEqual(['edit', null]);
  });
});
