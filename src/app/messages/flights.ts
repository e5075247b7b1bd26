import { signal } from '@preact/signals';
import { flights } from './en-flights.js';

/** What every language must give for the log of flights. */
export type FlightMessages = typeof flights;

/** The words of the log in the language in force, apart from the others: they come with the log. */
export const flightMessages = signal<FlightMessages>(flights);
