import { createRequire } from 'node:module';
import { expect, test } from '@playwright/test';

const mockSerial = createRequire(import.meta.url).resolve('sidus-timer/mock-serial.global.js');

test('the page shows the temperature', async ({ page }) => {
  await page.addInitScript({ path: mockSerial });
  await page.addInitScript(() => {
    const serial = new globalThis.SidusMockSerial.MockSerial({ userActivation: true });
    Object.defineProperty(navigator, 'serial', { value: serial });
    window.thermometer = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
    serial.choose(window.thermometer);
  });
  await page.goto('/thermometer.html');
  await page.getByRole('button', { name: 'Connect' }).click();
  const asked = await page.evaluate(async () => {
    const { device } = window.thermometer;
    const bytes = await device.read();
    device.write(new TextEncoder().encode('21.5\n'));
    return new TextDecoder().decode(bytes);
  });
  expect(asked).toBe('T?\n');
  await expect(page.getByRole('status')).toHaveText('21.5 °C');
});
