import { defineConfig } from '@playwright/test';
import { CHROMIUM_ARGS, findChromium } from '../../web/scripts/chromium.mjs';

// One port for all the processes of a run, and another for a run beside it.
process.env.PORT ??= String(20_000 + (process.pid % 20_000));
const origin = `http://localhost:${process.env.PORT}`;

const chromium = findChromium();

export default defineConfig({
  testDir: '.',
  outputDir: '../../test-results',
  fullyParallel: true,
  workers: 2,
  // Graphics run on the processor, which a machine may have little of: what is waited for may come late, never wrongly.
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: 'list',
  use: {
    baseURL: origin,
    viewport: { width: 900, height: 700 },
    trace: 'retain-on-failure',
    launchOptions: { args: CHROMIUM_ARGS, ...(chromium ? { executablePath: chromium } : {}) },
  },
  webServer: { command: 'node serve.mjs', url: `${origin}/harness/`, timeout: 120_000 },
});
