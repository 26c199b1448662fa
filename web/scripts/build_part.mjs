import { step, toolPath } from './steps.mjs';

/**
 * Builds a part of the page by Vite, into the folder that its configuration names.
 * @param {string} title
 * @param {string} config
 */
export function buildPart(title, config) {
  return step(
    title,
    process.execPath,
    [toolPath('vite'), 'build', '--config', config],
    'It does not build. The reason is above.',
  );
}
