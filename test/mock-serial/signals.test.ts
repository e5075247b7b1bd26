import { describe, expect, test } from 'vitest';
import { MockSerial, type OutputSignals } from '../../src/mock-serial/index.js';
import { failure, openPort } from './helper.js';

describe('setSignals() method', () => {
  test('step 4: sets what is given and leaves the rest', async () => {
    const { port, device } = await openPort();
    const steps: readonly (readonly [OutputSignals, boolean, boolean, boolean])[] = [
      [{ dataTerminalReady: false }, false, false, false],
      [{ requestToSend: true }, false, true, false],
      [{ break: true }, false, true, true],
      [{ dataTerminalReady: true, requestToSend: false, break: false }, true, false, false],
    ];
    for (const [signals, dataTerminalReady, requestToSend, breaking] of steps) {
      await port.setSignals(signals);
      expect(device.signals).toEqual({ dataTerminalReady, requestToSend, break: breaking });
    }
  });

  test('step 4.4: NetworkError when the device fails, and nothing changes', async () => {
    const { port, device } = await openPort();
    device.failSignals = true;
    expect(await failure(port.setSignals({ break: true }))).toBe('NetworkError');
    expect(device.signals.break).toBe(false);
    device.failSignals = false;
    await port.setSignals({ break: true });
    expect(device.signals.break).toBe(true);
  });
});

test.each([true, false])('openRaisesRts %s', async (openRaisesRts) => {
  const port = new MockSerial({ chromium: { openRaisesRts } }).plug();
  await port.open({ baudRate: 9600 });
  expect(port.device.signals.requestToSend).toBe(openRaisesRts);
});

describe('getSignals() method', () => {
  test('step 3: gives what the device has set', async () => {
    const { port, device } = await openPort();
    const signals = { dataCarrierDetect: false, clearToSend: false, ringIndicator: false, dataSetReady: false };
    expect(await port.getSignals()).toEqual(signals);
    for (const name of ['dataCarrierDetect', 'clearToSend', 'ringIndicator', 'dataSetReady'] as const) {
      signals[name] = true;
      device.setSignals({ [name]: true });
      expect(await port.getSignals()).toEqual(signals);
    }
    device.setSignals({ clearToSend: false });
    expect(await port.getSignals()).toEqual({ ...signals, clearToSend: false });
  });

  test('step 3.2: NetworkError when the device fails', async () => {
    const { port, device } = await openPort();
    device.failSignals = true;
    expect(await failure(port.getSignals())).toBe('NetworkError');
  });
});
