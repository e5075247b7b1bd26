import { messages } from '../messages/index.js';

/** The place of the models and their settings: empty until there are any. */
export function LibraryView() {
  const { library } = messages.value;
  return (
    <section class="empty-place">
      <h1>{library.title}</h1>
      <p>{library.empty}</p>
    </section>
  );
}
