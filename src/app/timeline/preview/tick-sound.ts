import { type Service, service, tried } from '../../browser/services.js';

/** How a tick sounds: hertz, seconds, and how loud it begins. */
const HIGH = 1400;
const LOW = 500;
const LENGTH = 0.07;
const LOUDNESS = 0.25;

/**
 * Short ticks from the loudspeaker. It makes its first use of the loudspeaker when it is first asked to, as browsers
 * want it.
 */
export class TickSound {
  #context: InstanceType<Service<'AudioContext'>> | null = null;

  /** To be called on a click: only then a browser lets sound through. */
  allow(): void {
    const Context = service('AudioContext');
    // Where there is no sound a flight is watched anyway.
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

  /** Gives the loudspeaker back. */
  close(): void {
    void tried(() => this.#context?.close().catch(() => {}));
    this.#context = null;
  }
}
