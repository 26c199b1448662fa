import { cpSync } from 'node:fs';

cpSync('node_modules/c2warp/web/dist/element', 'site/element', { recursive: true });
