// Follows one timer through Web Serial: finds the rate at which it answers, waits while it sleeps, and comes back after
// the cable was pulled. Nothing is written, and nothing moves.

import { TimerLink } from 'sidus-timer/serial';

/**
 * @param {import('sidus-timer/serial').SerialLike} serial `navigator.serial`
 * @param {(line: string) => void} show
 * @returns {TimerLink} call `choose()` on a click, `stop()` to end
 */
export function watch(serial, show) {
  /** The rate at which a timer last answered, by port. It is tried first. @type {Map<string, number>} */
  const rates = new Map();
  const link = new TimerLink({
    serial,
    remembered: (portKey) => ({ knownRate: rates.get(portKey) }),
    onState(state) {
      show(sentenceOf(state));
      if (state.status === 'on') void read(state);
    },
  });

  /** @param {import('sidus-timer/serial').LinkState & { status: 'on' }} state */
  async function read(state) {
    const { client, portKey, settings } = state.connection;
    rates.set(portKey, settings.baudRate);
    try {
      const { times, memory } = await client.readProgram();
      const name = memory === null ? 'A memory' : `M${memory + 1}`;
      if (link.state === state) show(`${name}: DT ${((times.at(-1) ?? 0) / 100).toFixed(2)} s`);
    } catch (error) {
      // If the state has changed, it was shown already. Otherwise the timer has fallen silent: keep asking.
      if (link.state !== state) return;
      show(`Not read: ${error instanceof Error ? error.message : error}`);
      link.wait();
    }
  }
  return link;
}

/** @param {import('sidus-timer/serial').LinkState} state */
function sentenceOf(state) {
  switch (state.status) {
    case 'choosing':
      return 'Choose the adapter';
    case 'opening':
      return state.refusals > 0 ? 'The port does not open: is it in use?' : 'Opening the port';
    case 'searching':
      return `Asking at ${state.baudRate} bits a second`;
    case 'waiting':
      return state.heard ? 'Something else talks on this port' : 'No answer: wake the timer';
    case 'on':
      return `Class ${state.connection.identity.timerClass}, firmware ${state.connection.identity.firmware}`;
    case 'away':
      return state.unplugged ? 'Unplugged: plug it in again' : 'The connection was lost';
    case 'closing':
      return 'Closing the port';
    case 'off':
      return state.error ? `Not connected: ${state.error.code}` : 'Not connected';
  }
}
