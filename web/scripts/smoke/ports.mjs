/** Ports of servers on this machine. */
import { createServer } from 'node:net';
import { StepError } from '../steps.mjs';

const PATIENCE_MS = 120_000;

/** A port that nothing listens on. @returns {Promise<number>} */
export const freePort = () =>
  new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', reject);
    server.listen(0, 'localhost', () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });

/** Waits until an address answers. @param {string} url */
export async function until(url) {
  const end = performance.now() + PATIENCE_MS;
  while (!(await answers(url))) {
    if (performance.now() > end) throw new StepError(`${url} does not answer.`);
    await new Promise((done) => setTimeout(done, 100));
  }
}

/** @param {string} url */
const answers = (url) =>
  fetch(url).then(
    ({ ok }) => ok,
    () => false,
  );
