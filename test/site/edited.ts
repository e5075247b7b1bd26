import { AppPage } from './app-page.js';

/** A pilot who has connected, and has edited a time and a position. */
export async function edited(): Promise<AppPage> {
  const app = await AppPage.connected();
  await app.type('DT time', '4:00');
  await app.type('Function 2, S1', '7');
  return app;
}

/** DT and the position of S1 at function 2, as the timer holds them. */
export const held = (app: AppPage): Promise<(number | undefined)[]> =>
  app.bench(({ content: { times, positions } }) => [times[10], positions[0]?.[2]]);
