import { copyFileSync, readdirSync } from 'node:fs';
import { build } from 'esbuild';

await build({ entryPoints: ['main.js'], bundle: true, splitting: true, format: 'esm', outdir: 'site' });

// esbuild leaves `new URL('./file', import.meta.url)` alone: the workers and modules go beside the bundle.
const element = 'node_modules/c2warp/web/dist/element';
for (const file of readdirSync(element)) {
  if (/\.(js|wasm)$/.test(file)) copyFileSync(`${element}/${file}`, `site/${file}`);
}
