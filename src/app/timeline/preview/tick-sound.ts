import { type Service, service, tried } from '../../browser/services.js';

/** The sound of a tick: hertz, seconds, and its volume at the beginning. */
const HIGH = 1400;
const LOW = 500;
const LENGTH = 0.07;
const LOUDNESS = 0.25;

/** Short ticks. It opens the loudspeaker only when it is first asked to, as browsers require. */
export class TickSound {
  #context: InstanceType<Service<'AudioContext'>> | null = null;

  /** Call it on a click: only then a browser allows sound. */
  allow(): void {
    const Context = service('AudioContext');
    // Without sound the flight can still be watched.
    this.#context ??= tried(() => Context && new Context());
    void tried(() => this.#context?.resume().catch(() => {}));
  }

  /** @param low the deeper tick of DT. */
  tick(low: boolean): void {
    const context = this.#context;
    if (!context) return;
    const start = context.currentTime;
    const tone = new OscillatorNode(context, { type: 'triangle', frequency: low ? LOW : HIGH });
    const loudness = new GainNode(context, { gain: LOUDNESS });
    loudness.gain.exponentialRampToValueAtTime(0.001, start + LENGTH * (low ? 4 : 1));
    tone.connect(loudness).connect(context.destination);
    tone.start(start);
    tone.stop(start + LENGTH * (low ? 4 : 1));
  }

  /** Releases the loudspeaker. */
  close(): void {
    void tried(() => this.#context?.close().catch(() => {}));
    this.#context = null;
  }
}
