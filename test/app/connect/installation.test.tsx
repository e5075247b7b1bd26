import { expect, it } from 'vitest';
import { Installation } from '../../../src/app/connect/installation.js';

it('offers to install the page while the browser does, and asks once', () => {
  const installation = new Installation();
  const window = new EventTarget();
  installation.follow(window);
  expect(installation.install.value).toBeNull();
  let asked = 0;
  const offer = () =>
    window.dispatchEvent(Object.assign(new Event('beforeinstallprompt'), { prompt: async () => void asked++ }));
  offer();
  installation.install.value?.();
  expect([asked, installation.install.value]).toEqual([1, null]);
  offer();
  window.dispatchEvent(new Event('appinstalled'));
  expect(installation.install.value).toBeNull();
});
