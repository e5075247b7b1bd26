import { obstacles } from '../messages/en-library.js';
import { messages } from '../messages/index.js';
import type { ShowObstacle } from '../work/open-setting.js';

/** Why a saved program cannot be opened now. */
export function obstacleText(obstacle: ShowObstacle): string {
  return obstacle === 'not-fitting' ? messages.value.notFitting : obstacles[obstacle];
}
