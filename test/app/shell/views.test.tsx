import { render, screen } from '@testing-library/preact';
import { expect, it, onTestFinished, vi } from 'vitest';
import { Views } from '../../../src/app/shell/views.js';
import { Modal } from '../../../src/app/ui/modal.js';
import { historyFrom } from '../history.js';

function following(...hashes: string[]) {
  const past = historyFrom(...hashes);
  const views = new Views();
  onTestFinished(views.follow(past.window));
  return { ...past, views };
}

function open(held: boolean) {
  const onEscape = vi.fn();
  const dialog = (isOpen: boolean) => (
    <Modal open={isOpen} title="Question" held={held} onEscape={onEscape}>
      text
    </Modal>
  );
  const { rerender, unmount } = render(dialog(true));
  return { onEscape, close: () => rerender(dialog(false)), unmount };
}

it('Back leads through the views when no dialog is open', () => {
  const { back, forward, views, shown } = following('#settings', '#program');
  open(false).close();
  back();
  expect([views.shown.value, shown()]).toEqual(['settings', ['#settings']]);
  forward();
  expect([views.shown.value, shown()]).toEqual(['program', ['#settings', '#program']]);
});

it('Back closes an open dialog once, and stays in the view', () => {
  const { back, views, shown } = following('#settings', '#program');
  const { onEscape, close } = open(false);
  back();
  expect([onEscape.mock.calls.length, views.shown.value, shown()]).toEqual([1, 'program', ['#settings', '#program']]);
  close();
  back();
  expect([onEscape.mock.calls.length, views.shown.value, shown()]).toEqual([1, 'settings', ['#settings']]);
});

it('Back neither closes a dialog that has to stay open, nor changes the view behind it', () => {
  const { back, views, shown } = following('#settings', '#program');
  const { onEscape, unmount } = open(true);
  back();
  back();
  expect([onEscape.mock.calls.length, views.shown.value, shown()]).toEqual([0, 'program', ['#settings', '#program']]);
  expect(screen.getByRole<HTMLDialogElement>('dialog', { name: 'Question' }).open).toBe(true);
  unmount();
  back();
  expect(views.shown.value).toBe('settings');
});

it('an address that is entered is shown, also behind a dialog, and Back from there closes it', () => {
  const { back, enter, views, shown } = following('#program');
  const { onEscape } = open(false);
  enter('#line');
  expect([onEscape.mock.calls.length, views.shown.value, shown()]).toEqual([0, 'line', ['#program', '#line']]);
  back();
  expect([onEscape.mock.calls.length, views.shown.value]).toEqual([1, 'line']);
});

it('Back closes the topmost dialog first', () => {
  const { back } = following('#settings', '#program');
  const below = open(false);
  const above = open(false);
  back();
  above.close();
  expect([below.onEscape.mock.calls.length, above.onEscape.mock.calls.length]).toEqual([0, 1]);
  back();
  expect(below.onEscape.mock.calls.length).toBe(1);
});
