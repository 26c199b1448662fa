import { defineConfig } from '@playwright/test';
import { CHROMIUM_ARGS, findChromium } from '../../web/scripts/chromium.mjs';

// All processes of a run share a port. Concurrent runs have different ports.
process.env.PORT ??= String(20_000 + (process.pid % 20_000));
const origin = `http://localhost:${process.env.PORT}`;

const chromium = findChromium();
// Pages are put together without WebGL, which the CPU would emulate. That takes a fifth less of its time.
const args = [...CHROMIUM_ARGS, '--disable-gpu-compositing'];

export default defineConfig({
  testDir: '.',
  outputDir: '../../test-results',
  fullyParallel: true,
  workers: 2,
  // Graphics run on the CPU, so slow machines need long timeouts.
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: 'list',
  use: {
    baseURL: origin,
    viewport: { width: 900, height: 700 },
    // Its downloads take time, and `page.route` does not see them. `app.spec.ts` allows it.
    serviceWorkers: 'block',
    // A trace of every step takes a quarter of a run. `--trace on` records it where it is wanted.
    screenshot: 'only-on-failure',
    launchOptions: { args, ...(chromium ? { executablePath: chromium } : {}) },
  },
  webServer: { command: 'node serve.mjs', url: `${origin}/harness/`, timeout: 120_000 },
});
