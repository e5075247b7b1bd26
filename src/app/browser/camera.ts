import { service } from './services.js';

/** Why there is no camera: not given, none there, in use by another program, no such service, or anything else. */
export type CameraFault = 'denied' | 'none' | 'taken' | 'missing' | 'failed';

/** A camera that is on. */
export interface Camera {
  readonly stream: MediaStream;
  /** Switches it off. */
  stop(): void;
  /** Calls back when it is taken away: it was unplugged, or the browser has stopped it. */
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

/** Asks for the camera at the back. The browser asks the pilot first: that can take as long as the pilot does. */
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
