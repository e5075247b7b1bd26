import { useSignal } from '@preact/signals';
import { useEffect, useId } from 'preact/hooks';
import { onPageKey } from '../browser/page-keys.js';
import { messages } from '../messages/index.js';
import { foldedText, searchFor } from '../messages/search.js';
import { Modal } from '../ui/modal.js';
import './palette.css';

/** A command that is possible now, with its name. */
export interface PaletteCommand {
  readonly name: string;
  /** The keys for the same command. */
  readonly keys?: string | undefined;
  readonly run: () => void;
}

interface PaletteProps {
  /** The commands that are possible now. */
  readonly commands: () => readonly PaletteCommand[];
}

/** A list of all commands with their keys, opened by Ctrl+K or Cmd+K. Nothing of it is made while it is closed. */
export function Palette({ commands }: PaletteProps) {
  const open = useSignal(false);
  useEffect(
    () =>
      onPageKey('commands', () => {
        // Over another dialog it would hide the question of that one.
        if (!open.peek() && document.querySelector('dialog[open]') !== null) return false;
        open.value = !open.peek();
        return true;
      }),
    [open],
  );
  const close = (): void => {
    open.value = false;
  };
  const { palette } = messages.value;
  return (
    <Modal open={open.value} title={palette.title} onEscape={close}>
      <Choice commands={commands} onClose={close} />
    </Modal>
  );
}

function Choice({ commands, onClose }: PaletteProps & { readonly onClose: () => void }) {
  const { palette } = messages.value;
  const text = useSignal('');
  const at = useSignal(0);
  const list = useId();
  const isFound = searchFor(text.value);
  const found = commands().filter(({ name }) => isFound(foldedText(name)));
  const last = found.length - 1;
  const chosen = Math.min(at.value, last);
  const run = (command: PaletteCommand | undefined): void => {
    if (!command) return;
    // Closes first: the command may open a dialog of its own.
    onClose();
    command.run();
  };
  const onKey = (event: KeyboardEvent): void => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined && event.key !== 'Enter') return;
    event.preventDefault();
    if (step === undefined) run(found[chosen]);
    else at.value = Math.max(0, Math.min(last, chosen + step));
  };
  const id = (index: number): string => `${list}-${index}`;
  return (
    <div class="stack palette">
      <input
        autofocus
        type="text"
        list={undefined}
        // biome-ignore lint/a11y/noRedundantRoles: without a list of its own it is none
        role="combobox"
        aria-expanded="true"
        aria-controls={list}
        aria-activedescendant={found.length > 0 ? id(chosen) : undefined}
        aria-label={palette.search}
        placeholder={palette.search}
        autocomplete="off"
        value={text.value}
        onInput={(event) => {
          text.value = event.currentTarget.value;
          at.value = 0;
        }}
        onKeyDown={onKey}
      />
      <div id={list} class="palette-list" role="listbox" tabIndex={-1} aria-label={palette.title}>
        {found.map((command, index) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: the field above has the keys
          <div
            key={command.name}
            id={id(index)}
            role="option"
            tabIndex={-1}
            aria-selected={index === chosen}
            ref={(row) => {
              if (index === chosen) row?.scrollIntoView?.({ block: 'nearest' });
            }}
            onClick={() => run(command)}
          >
            <span>{command.name}</span>
            {command.keys && <kbd>{command.keys}</kbd>}
          </div>
        ))}
      </div>
      {found.length === 0 && (
        <p class="hint" role="status">
          {palette.nothing}
        </p>
      )}
    </div>
  );
}
