import { service } from './services.js';

/**
 * Why there is no camera. `denied`: the pilot or the browser refuses. `none`: there is none. `taken`: another program
 * uses it. `missing`: the browser has no such service. `failed`: anything else.
 */
export type CameraFault = 'denied' | 'none' | 'taken' | 'missing' | 'failed';

/** A camera that is switched on. */
export interface Camera {
  readonly stream: MediaStream;
  /** Switches the camera off. */
  stop(): void;
  /** Calls back when the camera goes away: it was unplugged, or the browser has stopped it. */
  onEnd(callback: () => void): void;
}

const FAULTS: Readonly<Record<string, CameraFault>> = {
  NotAllowedError: 'denied',
  SecurityError: 'denied',
  NotFoundError: 'none',
  OverconstrainedError: 'none',
  NotReadableError: 'taken',
  AbortError: 'taken',
};

/** Whether this browser gives cameras to pages. */
export function hasCamera(): boolean {
  return service('mediaDevices') !== null;
}

/**
 * Asks for the camera on the back of the device.
 * The browser asks the pilot first, which takes as long as the pilot does.
 */
export async function openCamera(): Promise<Camera | { readonly fault: CameraFault }> {
  const devices = service('mediaDevices');
  if (!devices) return { fault: 'missing' };
  try {
    const stream = await devices.getUserMedia({ video: { facingMode: 'environment' }, audio: false });
    return {
      stream,
      stop: () => {
        for (const track of stream.getTracks()) track.stop();
      },
      onEnd: (callback) => {
        for (const track of stream.getTracks()) track.addEventListener('ended', callback);
      },
    };
  } catch (cause) {
    return { fault: (cause instanceof DOMException && FAULTS[cause.name]) || 'failed' };
  }
}
