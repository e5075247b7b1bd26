import { describe, expect, it } from 'vitest';
import { FrameForm } from '../../../src/app/line/frame-form.js';
import { toHex } from '../../tools/bytes.js';
import { connectedBench, idle, run } from '../bench/bench.js';

/** A pilot before the form, connected to a timer, who has said that it is safe. */
async function atForm() {
  const bench = await connectedBench();
  const { answered } = bench.timer.core;
  answered.length = 0;
  bench.session.safety.confirm();
  const form = new FrameForm(bench.session);
  const asking = (typed: string): void => {
    form.type(typed);
    form.ask();
  };
  return { ...bench, form, asking, asked: () => answered.map(({ name }) => name) };
}

const READ_ALL = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER'];

describe('a frame by hand', () => {
  it.each([
    ['6b', '00 00 00 00 00 03 6b 6b 45'],
    ['0x63 04 01 46', '00 00 00 00 00 06 63 04 01 46 ae 45'],
    ['63040146', '00 00 00 00 00 06 63 04 01 46 ae 45'],
    ['63, 04\n0X01 46', '00 00 00 00 00 06 63 04 01 46 ae 45'],
  ])('has its length, checksum and end filled in: %j', async (typed, bytes) => {
    const { form } = await atForm();
    form.type(typed);
    expect(form.fault.value).toBeNull();
    expect(toHex(form.bytes.value as Uint8Array)).toBe(bytes);
  });

  it('is of at most 252 bytes of data', async () => {
    const { form } = await atForm();
    form.type('00'.repeat(253));
    expect([form.fault.value, form.frame.value?.data.length]).toEqual([null, 252]);
    form.type('00'.repeat(254));
    expect([form.fault.value, form.frame.value]).toEqual(['too-long', null]);
  });

  it.each([
    ['', null],
    ['0', 'hex'],
    ['6b 1', 'hex'],
    ['6 b', 'hex'],
    ['0g', 'hex'],
    ['-1', 'hex'],
    ['0x', 'hex'],
  ])('is not made of %j', async (typed, fault) => {
    const { form, asking } = await atForm();
    asking(typed);
    expect([form.fault.value, form.bytes.value, form.ready.value, form.asking.value]).toEqual([
      fault,
      null,
      false,
      false,
    ]);
  });

  it.each([
    ['71', 'GETMEMORY'],
    ['6d', 'UNLOCK'],
  ])('needs a second click and is sent once, then all is read: %s', async (typed, command) => {
    const { form, asking, asked } = await atForm();
    asking(typed);
    form.ask();
    await idle();
    expect(form.asking.value).toBe(true);
    expect(asked(), 'nothing is sent before the pilot confirms it').toEqual([]);
    const sending = form.confirm();
    await form.confirm();
    form.ask();
    await run(sending);
    await form.confirm();
    await idle();
    expect(form.asking.value).toBe(false);
    expect(asked()).toEqual([command, ...READ_ALL]);
  });

  it('is not sent while nobody has said that it is safe', async () => {
    const { form, session, asking, asked } = await atForm();
    session.safety.withdraw();
    asking('6d');
    await run(form.confirm());
    expect([form.asking.value, asked()]).toEqual([true, []]);
  });

  it('occupies the line as any other job does', async () => {
    const { form, session, timer, asking, asked } = await atForm();
    timer.core.sleep();
    asking('71');
    const sending = form.confirm();
    expect([form.sending.value, session.runner.busy.value]).toEqual([true, true]);
    form.type('61');
    expect([await session.reader.read(), asked()], 'nothing else is sent meanwhile').toEqual([false, []]);
    await run(sending);
    expect([form.typed.value, form.sending.value, session.runner.busy.value]).toEqual(['71', false, false]);
  });

  it('shows its reply, and what the timer holds once it was changed', async () => {
    const { form, editor, asking } = await atForm();
    asking('63 04 01 46');
    await run(form.confirm());
    expect(form.result.value?.reply).toEqual({ code: 0x64, data: new Uint8Array() });
    expect(editor.baseline.value?.positions[1]?.[4]).toBe(70);
  });

  it('makes it unknown which memory flies next, until the timer says it', async () => {
    const { form, session, timer, asking } = await atForm();
    asking('73 02');
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

  it('is no longer waiting for a yes when it is changed, cancelled, or the connection is new', async () => {
    const { form, session, asking, asked } = await atForm();
    asking('6d');
    form.type('69 00');
    await form.confirm();
    asking('6d');
    form.cancel();
    await form.confirm();
    asking('6d');
    await run(session.timer.disconnect());
    await form.confirm();
    await run(session.timer.connect());
    expect(form.asking.value).toBe(false);
    session.safety.confirm();
    await form.confirm();
    await idle();
    expect(asked().filter((name) => name === 'UNLOCK' || name === 'MOVETOFUNC')).toEqual([]);
  });

  it('says when no reply came, and still reads what the timer holds', async () => {
    const { form, asking, asked } = await atForm();
    asking('79');
    await run(form.confirm());
    expect(form.result.value).toEqual({ reply: null });
    expect(asked().slice(-READ_ALL.length)).toEqual(READ_ALL);
  });

  it('cannot be sent without a connection, or while something else is on the wire', async () => {
    const { form, session, asking } = await atForm();
    const reading = session.reader.read();
    asking('71');
    expect([form.ready.value, form.asking.value]).toEqual([false, false]);
    await run(reading);
    expect(form.ready.value).toBe(true);
    await run(session.timer.disconnect());
    form.ask();
    expect([form.ready.value, form.asking.value]).toEqual([false, false]);
  });

  it('is not sent any more when the pilot stops it while the line is waited for', async () => {
    const { form, session, timer, asking, asked } = await atForm();
    timer.core.sleep();
    void session.reader.read();
    await idle(200);
    void session.runner.stop();
    await run(session.runner.ended());
    asking('6d');
    // An answer to the request before may still come, so this one waits.
    const sending = form.confirm();
    await idle(200);
    timer.core.press();
    void session.runner.stop();
    await run(sending);
    await idle();
    expect(asked()).not.toContain('UNLOCK');
    expect([form.sending.value, form.result.value]).toEqual([false, null]);
  });
});
