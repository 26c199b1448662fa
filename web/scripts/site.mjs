import { ROOT, step, toolPath } from './steps.mjs';

/**
 * Builds the pages of the site, without the element and the documentation of the library.
 * @param {string} folder Where the files go. It is emptied first.
 * @param {string} base The path of the site on its server: it begins and ends with a slash.
 */
export function buildPages(folder, base) {
  return step(
    'Pages of the site',
    process.execPath,
    [toolPath('vitepress'), 'build', `${ROOT}web/site`, '--outDir', folder, '--base', base],
    'The site does not build. The reason is above.',
  );
}
