import { signal } from '@preact/signals';
import { flights } from './en-flights.js';

/** Every language must have these sentences about the log of flights. */
export type FlightMessages = typeof flights;

/** The sentences about the log in the current language. They are loaded with the log. */
export const flightMessages = signal<FlightMessages>(flights);
