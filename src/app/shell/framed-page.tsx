import { messages } from '../messages/index.js';
import './framed-page.css';

/** Whether this page stands inside another one, which could lay something over its buttons. */
export function isFramed({ self, top }: Pick<Window, 'self' | 'top'>): boolean {
  return top !== self;
}

/** Replaces the program inside another page: says where the page works. */
export function FramedPage({ address }: { address: string }) {
  const { framed } = messages.value;
  return (
    <main class="framed">
      <h1>{framed.title}</h1>
      <p>
        <a href={address} target="_blank" rel="noopener noreferrer">
          {framed.open}
        </a>
      </p>
      <p class="hint">{address}</p>
    </main>
  );
}
