import { messages } from '../messages/index.js';
import { useModels } from '../models.js';

/** What this browser does not keep, as long as that is so; nothing when all is well. */
export function KeepingNotice() {
  const { keeping } = useModels();
  const { keeping: words, dismiss } = messages.value;
  const storage = keeping.storage.value;
  const lacks = keeping.lacks.value;
  if ((!storage && lacks.length === 0) || keeping.dismissed.value) return null;
  return (
    <div class="notice bad">
      <p>
        <strong>{words.title}</strong> {storage && words.storage[storage]}{' '}
        {lacks.map((lack) => words.lacks[lack]).join(' ')}
      </p>
      <button type="button" class="quiet" onClick={() => keeping.dismiss()}>
        {dismiss}
      </button>
    </div>
  );
}
