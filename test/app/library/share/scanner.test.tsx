import { act, fireEvent, screen, within } from '@testing-library/preact';
import { afterEach, beforeEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { linkOf, sharedOf } from '../../../../src/app/session/setting-link.js';
import { MODEL, SETTING } from '../../../program/library-examples.js';
import { idle } from '../../bench/bench.js';
import { opened, press } from '../../screen.js';

const LINK = linkOf(sharedOf(SETTING, MODEL), 'https://pilot.example/');
const dialog = () => within(screen.getByRole('dialog'));

class Track extends EventTarget {
  stopped = false;

  stop(): void {
    this.stopped = true;
  }
}

/** A camera that can be asked for, in a browser that finds what `seen` holds. */
function camera({ seen = [] as string[], fault = '' } = {}) {
  const tracks: Track[] = [];
  let grant = (): void => {};
  const asked = vi.fn((): Promise<MediaStream> => {
    if (fault) return Promise.reject(new DOMException('no', fault));
    const track = new Track();
    tracks.push(track);
    const stream = Object.assign(new MediaStream(), { getTracks: () => [track] as unknown as MediaStreamTrack[] });
    return new Promise((resolve) => {
      grant = () => resolve(stream);
    });
  });
  vi.stubGlobal('navigator', { mediaDevices: { getUserMedia: asked } });
  vi.stubGlobal(
    'BarcodeDetector',
    class {
      async detect() {
        return seen.map((rawValue) => ({ rawValue }));
      }
    },
  );
  return {
    asked,
    tracks,
    seen,
    async grant() {
      grant();
      await idle(200);
    },
  };
}

async function reading() {
  const bench = await opened();
  act(() => bench.sharing.read());
  await idle(0);
  return bench;
}

/** As much of a picture of 10 x 10 pixels as is looked at before the browser decodes it. */
const GIF = 'GIF89a\n\0\n\0';

// It is there before it is asked for: no clock of a test waits for a file.
await import('qr/decode.js');

beforeEach(() => {
  vi.spyOn(HTMLMediaElement.prototype, 'play').mockResolvedValue();
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('the camera', () => {
  it('starts only on a click, and stops when a setting was found', async () => {
    const { asked, tracks, grant, seen } = camera();
    const { sharing } = await reading();
    await idle();
    expect(asked).not.toHaveBeenCalled();
    fireEvent.click(screen.getByRole('button', { name: 'Use the camera' }));
    await idle(0);
    expect(dialog().getByText('Asking for the camera')).toBeTruthy();
    await grant();
    expect(dialog().getByText('Hold the QR code in the picture.')).toBeTruthy();
    seen.push('https://elsewhere.example');
    await idle(1000);
    expect(sharing.current.value?.step, 'another QR code in the picture is ignored').toBe('read');
    seen.splice(0, 1, LINK);
    await idle(1000);
    expect(sharing.current.value).toEqual({ step: 'received', link: LINK });
    expect(tracks.map(({ stopped }) => stopped)).toEqual([true]);
    expect(dialog().getByText('calm morning')).toBeTruthy();
  });

  it('is released when the pilot stops it or closes the dialog', async () => {
    const { tracks, grant } = camera();
    const { sharing } = await reading();
    fireEvent.click(screen.getByRole('button', { name: 'Use the camera' }));
    await grant();
    await press('Stop the camera');
    expect(tracks.map(({ stopped }) => stopped)).toEqual([true]);
    fireEvent.click(screen.getByRole('button', { name: 'Use the camera' }));
    await grant();
    act(() => sharing.close());
    await idle();
    expect(tracks.map(({ stopped }) => stopped)).toEqual([true, true]);
  });

  it('is released at once when nobody waits for it any more', async () => {
    const { tracks, grant } = camera();
    await reading();
    fireEvent.click(screen.getByRole('button', { name: 'Use the camera' }));
    await press('Close');
    await grant();
    expect(tracks.map(({ stopped }) => stopped)).toEqual([true]);
  });

  it.each([
    ['NotAllowedError', /does not let this page use the camera/],
    ['NotFoundError', /No camera was found/],
    ['NotReadableError', /Another program uses the camera/],
    ['TypeError', /could not be started/],
  ])('is reported when it does not come: %s', async (fault, sentence) => {
    camera({ fault });
    await reading();
    await press('Use the camera');
    expect(dialog().getByRole('alert').textContent).toMatch(sentence);
  });

  it('is reported when it is unplugged', async () => {
    const { tracks, grant } = camera();
    await reading();
    fireEvent.click(screen.getByRole('button', { name: 'Use the camera' }));
    await grant();
    act(() => void tracks[0]?.dispatchEvent(new Event('ended')));
    expect(dialog().getByRole('alert').textContent).toMatch(/Another program uses the camera/);
    expect(dialog().queryByRole('button', { name: 'Stop the camera' })).toBeNull();
  });
});

describe('a picture', () => {
  const choose = async (): Promise<void> => {
    fireEvent.change(screen.getByLabelText('Picture with a QR code'), {
      target: { files: [new File([GIF], 'code.gif', { type: 'image/gif' })] },
    });
    await idle();
  };

  it('with the code of a setting shows the setting', async () => {
    camera({ seen: [LINK] });
    vi.stubGlobal('createImageBitmap', async () => ({ width: 10, height: 10, close: () => {} }));
    const { sharing } = await reading();
    await choose();
    expect(sharing.current.value).toEqual({ step: 'received', link: LINK });
  });

  it('with another code shows the text of that code', async () => {
    camera({ seen: ['https://elsewhere.example'] });
    vi.stubGlobal('createImageBitmap', async () => ({ width: 10, height: 10, close: () => {} }));
    await reading();
    await choose();
    expect(dialog().getByRole('alert').textContent).toMatch(/holds no setting\. It says: https:\/\/elsewhere/);
  });

  it.each(['read', 'decoded'])('is reported when the file is not %s within a minute', async (what) => {
    camera();
    const silent = () => new Promise<never>(() => {});
    if (what === 'read') {
      const spy = vi.spyOn(Blob.prototype, 'arrayBuffer').mockImplementation(silent);
      onTestFinished(() => spy.mockRestore());
    } else vi.stubGlobal('createImageBitmap', silent);
    await reading();
    await choose();
    await idle(61_000);
    expect(dialog().getByRole('alert').textContent).toMatch(/could not be read as a picture/);
  });

  it('is reported when the file is not a picture', async () => {
    camera();
    vi.stubGlobal('createImageBitmap', () => Promise.reject(new DOMException('no', 'InvalidStateError')));
    await reading();
    await choose();
    expect(dialog().getByRole('alert').textContent).toMatch(/could not be read as a picture/);
  });
});

describe('a pasted link', () => {
  it('is shown, and another text is refused', async () => {
    vi.stubGlobal('navigator', {});
    const { sharing } = await reading();
    expect(
      screen.queryByRole('button', { name: 'Use the camera' }),
      'a device without a camera gets no button for it',
    ).toBeNull();
    const paste = async (text: string): Promise<void> => {
      fireEvent.input(dialog().getByRole('textbox', { name: 'Or paste a link' }), { target: { value: text } });
      await press('Show');
    };
    await paste('https://elsewhere.example');
    expect(dialog().getByRole('alert').textContent).toBe('This is not a link to a setting.');
    await paste(`Look: ${LINK.replace('#s=', '%23s%3D')} Bye.`);
    expect(sharing.current.value).toMatchObject({ step: 'received' });
    expect(dialog().getByText('calm morning')).toBeTruthy();
  });
});
