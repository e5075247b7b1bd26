import { render, screen } from '@testing-library/preact';
import { options, type VNode } from 'preact';
import { expect, it, onTestFinished, vi } from 'vitest';
import { Modal } from '../../../src/app/ui/modal.js';
import { run } from '../bench/bench.js';
import { connected, press, type } from '../screen.js';

/** Preact tells its tools by this option of each component that it draws. */
const hooks = options as { __r?: ((vnode: VNode) => void) | undefined };

/** The dialogs that are drawn from now on. */
function dialogsDrawn(): string[] {
  const drawn: string[] = [];
  const { __r: before } = hooks;
  onTestFinished(() => {
    hooks.__r = before;
  });
  hooks.__r = (vnode) => {
    const { name } = typeof vnode.type === 'function' ? vnode.type : { name: '' };
    if (/(Dialog|Modal)$/.test(name)) drawn.push(name);
    before?.(vnode);
  };
  return drawn;
}

it('a dialog is not in the page while it is closed, and is not drawn with other changes', async () => {
  const { session } = await connected();
  const drawn = dialogsDrawn();
  await run(session.reader.read());
  await type('DT time', '5:00');
  await type('Function 4, S2', '70');
  await run(session.reader.selectMemory(2));
  await press('Write…');
  await press('Cancel');
  // The dialog that was opened, which is meant; and what draws itself with its own part of the page.
  const meant = [...new Set(drawn)].filter((name) => name !== 'ServoDialog').sort();
  expect(meant).toEqual(['Modal', 'OpenModal', 'WriteDialog']);
  expect(document.querySelector('dialog')).toBeNull();
});

it('a dialog comes back when the browser closes it and its model has it still open', () => {
  const onEscape = vi.fn();
  const modal = (held: boolean) => (
    <Modal open title="Question…" held={held} onEscape={onEscape}>
      text
    </Modal>
  );
  const { rerender } = render(modal(true));
  const dialog = screen.getByRole<HTMLDialogElement>('dialog', { name: 'Question' });
  dialog.close();
  expect([dialog.open, onEscape.mock.calls.length]).toEqual([true, 0]);
  rerender(modal(false));
  dialog.close();
  expect([dialog.open, onEscape.mock.calls.length]).toEqual([false, 1]);
});

it('a dialog is closed before it is removed, and does not take that for Escape', () => {
  const onEscape = vi.fn();
  const modal = (open: boolean) => (
    <Modal open={open} title="Question" onEscape={onEscape}>
      text
    </Modal>
  );
  const { rerender } = render(modal(true));
  const dialog = screen.getByRole<HTMLDialogElement>('dialog');
  rerender(modal(false));
  dialog.dispatchEvent(new Event('close'));
  expect([dialog.open, onEscape.mock.calls.length]).toEqual([false, 0]);
  expect(screen.queryByRole('dialog')).toBeNull();
});
