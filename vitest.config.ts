import { defineConfig } from 'vitest/config';

/** One project for each floor of tests: a fault is caught on the lowest floor that can catch it. */
export default defineConfig({
  test: {
    projects: [
      {
        test: {
          name: 'unit',
          environment: 'node',
          include: ['test/{line,protocol,program,client,simulator,mock-serial,serial}/**/*.test.ts'],
        },
      },
    ],
  },
});
