import { useSignal } from '@preact/signals';
import { useLayoutEffect } from 'preact/hooks';
import type { TimerProgram } from '../../program/index.js';
import { CLASSES } from '../editing/new-program.js';
import { moreMessages } from '../messages/more.js';
import { newId } from '../records/library.js';
import type { ModelRecord } from '../storage/index.js';
import { NewProgramDialog } from '../ui/new-program-dialog.js';
import type { Session } from '../work/session.js';
import { NameField } from './name-field.js';
import { addressPath } from './place.js';

interface NewSettingProps {
  readonly open: boolean;
  readonly session: Session;
  /** The model that it is for; null for none. */
  readonly model: ModelRecord | null;
  readonly onClose: () => void;
  /** Goes to the place of the new setting in the library. */
  readonly onMade: (path: string) => void;
}

/** Makes a setting without a timer, with the layout of the model's other settings. */
export function NewSetting({ open, session, model, onClose, onMade }: NewSettingProps) {
  const { save } = moreMessages.value.library;
  const name = useSignal('');
  // Before anything can be typed.
  useLayoutEffect(() => {
    if (open) name.value = '';
  }, [open, name]);
  const of = model?.key ?? null;
  const known = session.library.settings.list.peek().find(({ setting }) => setting.model === of)?.setting
    .program.identity;
  const timerClass = CLASSES.find((each) => each === (model?.model.timerClass ?? known?.timerClass));
  const make = (program: TimerProgram): void => {
    const setting = {
      id: newId(),
      model: of,
      name: name.value.trim(),
      note: '',
      tags: [],
      at: Date.now(),
      program,
      from: 'typed' as const,
      archived: false,
    };
    void session.library.keepSetting(setting);
    onMade(addressPath(of, setting.id));
  };
  return (
    <NewProgramDialog
      open={open}
      like={{ ...(known && { functions: known.functions, servos: known.servos }), ...(timerClass && { timerClass }) }}
      onMake={make}
      onClose={onClose}
    >
      <NameField
        label={save.name({ of: 'program' })}
        placeholder={save.namePlace}
        value={name.value}
        onChange={(text) => (name.value = text)}
      />
    </NewProgramDialog>
  );
}
