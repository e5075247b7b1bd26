// Backs up a Sidus timer to a file.
//
//     node backup.js                          lists the serial ports
//     node backup.js PORT FILE [--all]        writes FILE, which must not be there yet
//
// Without --all it reads the current memory and changes nothing on the timer. With --all it makes one memory after the
// other current, and at the end the first one again.

import { existsSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import process, { stderr, stdout } from 'node:process';
import { Duplex } from 'node:stream';
import { parseArgs } from 'node:util';
import { SerialPort } from 'serialport';
import { TimerClient, TimerError } from 'sidus-timer/client';

const BAUD_RATE = 9600;

/**
 * Everything that the timer holds, or what its current memory holds.
 * @param {TimerClient} timer
 * @param {boolean} all
 */
async function read(timer, all) {
  const identity = await timer.identify();
  const current = await timer.readProgram();
  const programs = [current];
  if (all && current.memory === null) throw new Error('This timer does not say which of its memories is current.');
  if (all && current.memory !== null) {
    try {
      for (let memory = 0; memory < identity.memories; memory++) {
        if (memory === current.memory) continue;
        await timer.selectMemory(memory);
        programs.push(await timer.readProgram());
      }
    } finally {
      await timer.selectMemory(current.memory);
    }
  }
  return {
    timer: identity,
    units: 'times in hundredths of a second, positions in steps by servo and slot, memories from 0',
    memories: programs.map(({ identity: _, ...content }) => content),
  };
}

/**
 * Waits for what `serialport` says by a callback.
 * @param {(callback: (error: Error | null) => void) => void} action
 * @returns {Promise<void>}
 */
function settled(action) {
  return new Promise((resolve, reject) => action((error) => (error ? reject(error) : resolve())));
}

/**
 * @param {string} path
 * @param {string} file
 * @param {boolean} all
 */
async function backUp(path, file, all) {
  if (existsSync(file)) throw new Error(`${file} is there already.`);
  const port = new SerialPort({ path, baudRate: BAUD_RATE, autoOpen: false });
  await settled((callback) => port.open(callback));
  const timer = new TimerClient(Duplex.toWeb(port), { baudRate: BAUD_RATE });
  try {
    const content = await read(timer, all);
    await writeFile(file, `${JSON.stringify(content, null, 2)}\n`, { flag: 'wx' });
    return content;
  } finally {
    await timer.close();
    if (port.isOpen) await settled((callback) => port.close(callback));
  }
}

async function main() {
  const { positionals, values } = parseArgs({ allowPositionals: true, options: { all: { type: 'boolean' } } });
  const [path, file] = positionals;
  if (path === undefined || file === undefined) {
    for (const port of await SerialPort.list()) stdout.write(`${port.path} ${port.manufacturer ?? ''}\n`);
    stdout.write('node backup.js PORT FILE [--all]\n');
    return;
  }
  const { timer, memories } = await backUp(path, file, values.all === true);
  const { timerClass, firmware } = timer;
  stdout.write(`${timerClass} ${firmware}: ${memories.length} of ${timer.memories} memories are in ${file}.\n`);
}

try {
  await main();
} catch (error) {
  const code = error instanceof TimerError ? ` (${error.code})` : '';
  stderr.write(`${error instanceof Error ? error.message : error}${code}\n`);
  process.exitCode = 1;
}
