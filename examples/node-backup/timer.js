// A Sidus timer on the command line, through a serial port:
//
//     node timer.js                            lists the serial ports
//     node timer.js PORT                       shows what the current memory holds
//     node timer.js PORT dt SECONDS            sets DT in the current memory, reads it back and compares
//     node timer.js PORT backup FILE [--all]   writes FILE, which must not exist yet
//     node timer.js PORT restore FILE          writes the memories of FILE back, reads them back and compares
//
// The page opens this file, too. With --all, and to restore other memories than the current one, it makes them current
// one after the other, and at the end the first one again. Ctrl+C stops after the request in progress.
//
// Exit codes: 0 all was done, 1 an error, 2 wrong arguments, 3 the timer does not hold what was wanted, 130 stopped.

import { readFile, writeFile } from 'node:fs/promises';
import process, { stderr, stdout } from 'node:process';
import { Duplex } from 'node:stream';
import { parseArgs } from 'node:util';
import { SerialPort } from 'serialport';
import { TimerClient, TimerError } from 'sidus-timer/client';
import { errorText, findingText, slotName } from 'sidus-timer/english';
import { formatLibraryFile, parseLibraryFile } from 'sidus-timer/library';
import { checkProgram, seconds, withValue } from 'sidus-timer/program';

/** @import { JobOptions, Progress, WriteReport } from 'sidus-timer/client' */
/** @import { Setting } from 'sidus-timer/library' */
/** @import { TimerProgram } from 'sidus-timer/program' */

const BAUD_RATE = 9600;
const USAGE = 'node timer.js [PORT [dt SECONDS | backup FILE [--all] | restore FILE]]';
const DONE = 0;
const FAILED = 1;
const WRONG_CALL = 2;
const NOT_HELD = 3;
const STOPPED = 130;

/** @param {string} text */
const say = (text) => void stdout.write(`${text}\n`);

/**
 * Draws a progress bar on a terminal; nothing when the output goes to a file.
 * @param {Progress} progress
 */
function onProgress({ stage, fraction, memory }) {
  if (!stderr.isTTY) return;
  const bar = '#'.repeat(Math.round(fraction * 30)).padEnd(30, '.');
  stderr.write(`\r${bar} ${stage}${memory === null ? '' : ` M${memory + 1}`}  ${fraction === 1 ? '\n' : ''}`);
}

/**
 * What a memory holds, as a table: slot, time in seconds, position of each servo.
 * @param {TimerProgram} program
 */
function tableOf({ identity, memory, times, positions, idleThrottle }) {
  const { timerClass, firmware } = identity;
  const lines = times.map((time, slot) => {
    const seconds = slot === 0 ? '' : (time / 100).toFixed(2);
    return [
      slotName(identity, slot).padEnd(12),
      seconds.padStart(7),
      ...positions.map((row) => String(row[slot]).padStart(5)),
    ].join('');
  });
  const motorStop = timerClass === 'Q' ? `, motor stop ${((times[0] ?? 0) / 100).toFixed(2)} s` : '';
  const throttle = idleThrottle === null ? '' : `, idle throttle ${idleThrottle}`;
  const head = `${timerClass} ${firmware}, memory ${memory === null ? 'not known' : `M${memory + 1}`}`;
  const columns = [
    'Slot'.padEnd(12),
    'time/s'.padStart(7),
    ...positions.map((_, servo) => `S${servo + 1}`.padStart(5)),
  ];
  return [`${head}${motorStop}${throttle}`, columns.join(''), ...lines].join('\n');
}

/**
 * Prints the result of a write.
 * @param {WriteReport} report
 */
function tell({ result, values, stopped }) {
  const wrong = values.filter(({ status }) => status !== 'verified');
  for (const { field, wanted, held } of wrong) {
    say(`${JSON.stringify(field)}: wanted ${wanted}, the timer holds ${held ?? 'an unknown value'}`);
  }
  say(result === 'verified' ? 'Verified.' : `Not verified: ${stopped?.code ?? result}.`);
  if (stopped?.code === 'aborted') return STOPPED;
  return result === 'verified' ? DONE : NOT_HELD;
}

/** @param {TimerClient} timer @param {JobOptions} options @param {string} text */
async function setDt(timer, options, text) {
  const dt = Number(text);
  if (!/^\d+(\.\d{1,2})?$/.test(text) || dt > 655.35) throw new Error('DT is 0 to 655.35 seconds.');
  const baseline = await timer.readProgram(options);
  const { functions } = baseline.identity;
  const goal = withValue(baseline, { kind: 'time', slot: functions }, seconds(dt));
  for (const finding of checkProgram(goal, { baseline }))
    say(`${finding.severity}: ${findingText(finding, goal.identity)}`);
  return tell(await timer.writeProgram(goal, { ...options, baseline }));
}

/** @param {TimerClient} timer @param {JobOptions} options @param {string} file @param {boolean} all */
async function backUp(timer, options, file, all) {
  const current = all ? null : await timer.readProgram(options);
  const programs = current ? [current] : (await timer.readMemories(options)).programs;
  const at = Date.now();
  const settings = programs.map((program, index) => {
    const name = program.memory === null ? 'memory not known' : `M${program.memory + 1}`;
    const id = `backup-${at}-${index}`;
    /** @type {Setting} */
    const setting = { id, model: null, name, note: '', tags: [], at, program, from: 'timer', archived: false };
    return setting;
  });
  const text = formatLibraryFile(
    { models: [], settings, flights: [] },
    { writtenAt: at, writtenBy: 'sidus-timer example' },
  );
  await writeFile(file, text, { flag: 'wx' });
  const { timerClass, firmware, memories } = await timer.identify(options);
  say(`${timerClass} ${firmware}: ${programs.length} of ${memories} memories are in ${file}.`);
  return DONE;
}

/** @param {TimerClient} timer @param {JobOptions} options @param {string} file */
async function restore(timer, options, file) {
  const { settings } = parseLibraryFile(await readFile(file, 'utf8')).library;
  const goals = settings.map(({ program }) => program).filter(({ memory }) => memory !== null);
  if (goals.length === 0) throw new Error(`${file} holds no memory of a timer.`);
  // A backup goes back as it was, whatever the checks say of it.
  const despite = goals.flatMap((goal) => checkProgram(goal).map(({ code }) => code));
  const { memories, restored, stopped } = await timer.writeMemories(goals, { ...options, despite });
  let code = DONE;
  for (const { memory, report } of memories) {
    stdout.write(`M${memory + 1}: `);
    code = Math.max(code, tell(report));
  }
  if (!restored) say('The memory that was current before is not current again: make it fly next before you fly.');
  if (stopped) throw stopped;
  return restored && memories.length === goals.length ? code : NOT_HELD;
}

/**
 * Turns a callback of `serialport` into a promise.
 * @param {(callback: (error: Error | null) => void) => void} action
 * @returns {Promise<void>}
 */
function settled(action) {
  return new Promise((resolve, reject) => action((error) => (error ? reject(error) : resolve())));
}

/**
 * Opens the port for the time of the work.
 * @param {string} path
 * @param {(timer: TimerClient, options: JobOptions) => Promise<number>} work
 */
async function withTimer(path, work) {
  const port = new SerialPort({ path, baudRate: BAUD_RATE, autoOpen: false });
  await settled((callback) => port.open(callback));
  const stop = new AbortController();
  const onStop = () => stop.abort();
  process.on('SIGINT', onStop);
  const timer = new TimerClient(Duplex.toWeb(port), { baudRate: BAUD_RATE });
  try {
    return await work(timer, { signal: stop.signal, onProgress });
  } finally {
    process.off('SIGINT', onStop);
    await timer.close();
    if (port.isOpen) await settled((callback) => port.close(callback));
  }
}

/** Reads the arguments. Prints the usage and gives null when they make no sense. */
function understood() {
  try {
    return parseArgs({ allowPositionals: true, options: { all: { type: 'boolean' } } });
  } catch (error) {
    stderr.write(`${error instanceof Error ? error.message : error}\n${USAGE}\n`);
    return null;
  }
}

/** @returns {Promise<number>} */
async function main() {
  const call = understood();
  if (!call) return WRONG_CALL;
  const { positionals, values } = call;
  const [path, command = 'show', argument, ...more] = positionals;
  if (path === undefined) {
    for (const port of await SerialPort.list()) say(`${port.path} ${port.manufacturer ?? ''}`);
    say(USAGE);
    return DONE;
  }
  /** @type {Record<string, (timer: TimerClient, options: JobOptions, argument: string) => Promise<number>>} */
  const commands = {
    show: async (timer, options) => {
      say(tableOf(await timer.readProgram(options)));
      return DONE;
    },
    dt: setDt,
    backup: (timer, options, file) => backUp(timer, options, file, values.all === true),
    restore,
  };
  const run = Object.hasOwn(commands, command) ? commands[command] : undefined;
  if (!run || more.length > 0 || (command === 'show') !== (argument === undefined)) {
    stderr.write(`${USAGE}\n`);
    return WRONG_CALL;
  }
  return await withTimer(path, (timer, options) => run(timer, options, argument ?? ''));
}

try {
  process.exitCode = await main();
} catch (error) {
  const isTimer = error instanceof TimerError;
  stderr.write(`${errorText(error)}${isTimer ? ` (${error.code})` : ''}\n`);
  process.exitCode = isTimer && error.code === 'aborted' ? STOPPED : FAILED;
}
