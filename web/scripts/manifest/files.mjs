/** Adds the manifest, data for editors and types for frameworks to the package. */
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from '../steps.mjs';
import { cssData, htmlData, webTypes } from './editors.mjs';
import { frameworkTypes, reactComponent } from './frameworks.mjs';
import { elements, written } from './manifest.mjs';

export function writeManifestFiles() {
  const package_ = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
  const all = elements();
  const [warp] = all;
  if (!warp) throw new Error('there are no elements');
  rmSync(join(ROOT, 'web/dist/element/frameworks'), { recursive: true, force: true });
  write('element/custom-elements.json', json(written(all)));
  write('element/vscode.html-custom-data.json', json(htmlData(all)));
  write('element/vscode.css-custom-data.json', json(cssData(all)));
  write('element/web-types.json', json(webTypes(all, package_)));
  for (const [name, text] of Object.entries(frameworkTypes(all))) write(`element/frameworks/${name}`, text);
  write('react/c2warp-react.d.ts', reactComponent(warp));
}

/** @param {unknown} value */
const json = (value) => `${JSON.stringify(value, null, 2)}\n`;

/**
 * @param {string} path Below `web/dist`.
 * @param {string} text
 */
function write(path, text) {
  const file = join(ROOT, 'web/dist', path);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
}
