import { render, screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { en } from '../../../src/app/messages/en.js';
import { onDemand } from '../../../src/app/ui/on-demand.js';

const Text = ({ text }: { readonly text: string }) => <p>{text}</p>;

it('a part is fetched once when it is first shown, and says so meanwhile', async () => {
  let fetched = 0;
  const { Part, fetch } = onDemand(async () => {
    fetched++;
    return Text;
  });
  render(<Part text="here" />);
  expect(screen.getByText('Loading')).toBeTruthy();
  expect([(await screen.findByText('here')).tagName, screen.queryByText('Loading')]).toEqual(['P', null]);
  await fetch();
  expect(fetched).toBe(1);
});

it('a part that does not come says so, and can be fetched again', async () => {
  let broken = true;
  const { Part } = onDemand(async () => {
    if (broken) throw new Error('no network');
    return Text;
  });
  render(<Part text="here" />);
  await screen.findByText(en.parts.failed);
  broken = false;
  screen.getByRole('button', { name: en.parts.again }).click();
  await screen.findByText('here');
});

it('a part that is a dialog leaves nothing in its place', () => {
  const { Part } = onDemand(() => new Promise<typeof Text>(() => {}), { silent: true });
  const { container } = render(<Part text="here" />);
  expect(container.innerHTML).toBe('');
});

it('tells that a silent part did not come, until it does', async () => {
  let broken = true;
  const dialogs = onDemand(
    async () => {
      if (broken) throw new Error('no network');
      return Text;
    },
    { silent: true, later: true },
  );
  const { container } = render(<dialogs.Part text="here" />);
  expect(dialogs.hasFailed).toBe(false);
  await dialogs.fetch();
  expect([dialogs.hasFailed, container.innerHTML]).toEqual([true, '']);
  broken = false;
  await dialogs.fetch();
  expect(dialogs.hasFailed).toBe(false);
  await screen.findByText('here');
});

it('a part that can wait is not fetched when it is drawn, but when its turn comes', async () => {
  const dialogs = onDemand(async () => Text, { silent: true, later: true });
  const view = onDemand(async () => Text);
  const { container } = render(
    <>
      <dialogs.Part text="a dialog" />
      <view.Part text="the view" />
    </>,
  );
  expect([dialogs.isAskedFor, view.isAskedFor]).toEqual([false, true]);
  await screen.findByText('the view');
  expect(container.textContent).toBe('the view');
  await dialogs.fetch();
  await screen.findByText('a dialog');
});
