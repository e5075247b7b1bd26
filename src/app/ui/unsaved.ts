import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { useLayoutEffect } from 'preact/hooks';

const open = signal(0);

/** Whether anything is open that a reload would lose: a dialog, or a form with unsaved content. */
export const unsaved: ReadonlySignal<boolean> = computed(() => open.value > 0);

/** Reports whether a reload would lose something of the caller. Dialogs report it themselves, see {@link Modal}. */
export function useUnsaved(isUnsaved = true): void {
  useLayoutEffect(() => {
    if (!isUnsaved) return undefined;
    open.value++;
    return () => {
      open.value--;
    };
  }, [isUnsaved]);
}
