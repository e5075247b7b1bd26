import { useSignal } from '@preact/signals';
import { useEffect, useId, useRef } from 'preact/hooks';
import type { Model } from '../../program/index.js';
import type { PictureFault } from '../browser/picture.js';
import { libraryMessages } from '../messages/en-library.js';
import { Problem } from '../ui/problem.js';
import { drawPhoto, scaledPhoto } from './photo.js';
import './model-photo.css';

interface ModelPhotoProps {
  readonly model: Model;
  readonly onChange: (photo: string | null) => void;
}

/** A picture of the model, from a file or the camera. */
export function ModelPhoto({ model, onChange }: ModelPhotoProps) {
  const { model: words } = libraryMessages;
  const id = useId();
  const canvas = useRef<HTMLCanvasElement>(null);
  const fault = useSignal<PictureFault | null>(null);
  const busy = useSignal(false);
  const { photo } = model;
  useEffect(() => {
    const place = canvas.current;
    if (!place || photo === null) return;
    let isOld = false;
    // When a picture cannot be drawn any more, the page says so. The picture stays in the library.
    void drawPhoto(photo, place, () => isOld)
      .catch(() => 'unreadable' as const)
      .then((found) => {
        if (!isOld) fault.value = found;
      });
    return () => {
      isOld = true;
    };
  }, [photo, fault]);
  const take = async (file: File | undefined): Promise<void> => {
    if (!file) return;
    busy.value = true;
    fault.value = null;
    const scaled = await scaledPhoto(file).catch(() => ({ fault: 'unreadable' as const }));
    busy.value = false;
    if ('photo' in scaled) onChange(scaled.photo);
    else fault.value = scaled.fault;
  };
  return (
    <div class="model-photo">
      {photo !== null && <canvas ref={canvas} role="img" aria-label={words.photoOf(model.name)} />}
      <div class="buttons">
        <label class="photo-button" for={id} aria-busy={busy.value}>
          {photo === null ? words.takePhoto : words.changePhoto}
        </label>
        <input
          id={id}
          class="visually-hidden"
          type="file"
          accept="image/*"
          onChange={(event) => {
            const input = event.currentTarget;
            void take(input.files?.[0]).finally(() => {
              // So that the same file can be chosen again.
              input.value = '';
            });
          }}
        />
        {photo !== null && (
          <button type="button" class="quiet" onClick={() => onChange(null)}>
            {words.removePhoto}
          </button>
        )}
      </div>
      <Problem text={fault.value !== null && words.photoFaults[fault.value]} />
    </div>
  );
}
