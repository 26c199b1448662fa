/**
 * `npm run build`: writes the editor as static files to web/dist, the element for other pages to web/dist/element, the
 * player of rigs to web/dist/player, the component for React to web/dist/react, and the headless solver, with the
 * command, to web/dist/core. The manifest of the elements, and the files generated from it, are beside the element.
 */
import { copyFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildPart } from './build_part.mjs';
import { buildCommand } from './command.mjs';
import { writeDeclarations } from './declarations.mjs';
import { writeManifestFiles } from './manifest/files.mjs';
import { checkPlayerSize } from './player_size.mjs';
import { prepare } from './prepare.mjs';
import { main, ROOT } from './steps.mjs';

await main(async () => {
  await prepare();
  await buildPart('Editor', 'web/vite.config.ts');
  await buildPart('Element', 'web/vite.element.config.ts');
  await buildPart('Player', 'web/vite.player.config.ts');
  checkPlayerSize('web/dist');
  await buildPart('Component for React', 'web/vite.react.config.ts');
  await buildPart('Core', 'web/vite.core.config.ts');
  copyFileSync(await buildCommand(), join(ROOT, 'web/dist/core/command.wasm'));
  await writeDeclarations('web/dist/element/types', 'element');
  await writeDeclarations('web/dist/player/types', 'player');
  await writeDeclarations('web/dist/core/types', 'core');
  writeManifestFiles();
});
