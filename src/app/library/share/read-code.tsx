import { useSignal } from '@preact/signals';
import { useEffect, useId, useMemo, useRef } from 'preact/hooks';
import { hasCamera } from '../../browser/camera.js';
import { share } from '../../messages/en-share.js';
import { messages } from '../../messages/index.js';
import { Problem } from '../../ui/problem.js';
import { Scanner, type ScanState } from './scanner.js';
import { holdsLink, type Sharing } from './sharing.js';
import './read-code.css';

/** Reads a QR code or a link: from the camera, a picture, or pasted text. */
export function ReadCode({ sharing }: { readonly sharing: Sharing }) {
  const { read: words } = share;
  const scanner = useMemo(() => new Scanner((link) => sharing.take(link)), [sharing]);
  useEffect(() => () => scanner.stop(), [scanner]);
  const state = scanner.state.value;
  const isOn = state.kind === 'looking' || state.kind === 'starting';
  const file = useRef<HTMLInputElement>(null);
  return (
    <>
      <p>{words.lead}</p>
      <div class="read-from">
        {state.kind === 'looking' && <Finder stream={state.stream} scanner={scanner} />}
        <Said state={state} />
        <div class="buttons">
          {hasCamera() && (
            <button
              type="button"
              class={isOn ? '' : 'primary'}
              onClick={() => (isOn ? scanner.stop() : void scanner.start())}
            >
              {isOn ? words.stop : words.camera}
            </button>
          )}
          <button type="button" onClick={() => file.current?.click()}>
            {words.image}
          </button>
          <input
            ref={file}
            type="file"
            class="visually-hidden"
            tabIndex={-1}
            accept="image/*"
            aria-label={words.imageLabel}
            onChange={({ currentTarget }) => {
              const [chosen] = currentTarget.files ?? [];
              if (chosen) void scanner.readPicture(chosen);
              // So that the same file can be chosen again.
              currentTarget.value = '';
            }}
          />
        </div>
      </div>
      <Paste onLink={(link) => sharing.take(link)} />
      <div class="buttons">
        <button type="button" onClick={() => sharing.close()}>
          {messages.value.close}
        </button>
      </div>
    </>
  );
}

/** The live picture of the camera. */
function Finder({ stream, scanner }: { readonly stream: MediaStream; readonly scanner: Scanner }) {
  const { read: words } = share;
  const video = useRef<HTMLVideoElement>(null);
  useEffect(() => {
    const { current } = video;
    if (!current) return;
    current.srcObject = stream;
    void current.play().catch(() => {});
    const stop = scanner.watch(current);
    return () => {
      stop();
      current.srcObject = null;
    };
  }, [stream, scanner]);
  return <video ref={video} class="read-video" muted playsInline aria-label={words.view} />;
}

/** What is happening, and what went wrong. */
function Said({ state }: { readonly state: ScanState }) {
  const { read: words } = share;
  if (state.kind === 'fault' || state.kind === 'other') {
    return <Problem text={state.kind === 'fault' ? words.faults[state.fault] : words.other(shortened(state.text))} />;
  }
  const said = { idle: '', starting: words.starting, looking: words.looking, picture: words.reading }[state.kind];
  return <p role="status">{said}</p>;
}

/** How many characters of another QR code's text are shown. */
const SHOWN = 80;

function shortened(text: string): string {
  return text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text;
}

function Paste({ onLink }: { readonly onLink: (link: string) => void }) {
  const { read: words } = share;
  const id = useId();
  const text = useSignal('');
  const isWrong = useSignal(false);
  return (
    <form
      class="read-paste"
      onSubmit={(event) => {
        event.preventDefault();
        isWrong.value = !holdsLink(text.value);
        if (!isWrong.value) onLink(text.value);
      }}
    >
      <label for={id}>{words.paste}</label>
      <div class="read-line">
        <input
          id={id}
          type="text"
          value={text.value}
          autocomplete="off"
          spellcheck={false}
          onInput={({ currentTarget }) => {
            text.value = currentTarget.value;
            isWrong.value = false;
          }}
        />
        <button type="submit" disabled={text.value.trim() === ''}>
          {words.show}
        </button>
      </div>
      <Problem text={isWrong.value && words.notLink} />
    </form>
  );
}
