/** A Vite plugin that generates the tables of the React component from the manifest. */
import { reactListener, settable } from './frameworks.mjs';
import { elements } from './manifest.mjs';

const NAME = 'virtual:c2warp-react';

/** @returns {import('vite').Plugin} */
export const reactTables = () => ({
  name: 'c2warp:react-tables',
  resolveId: (id) => (id === NAME ? `\0${NAME}` : null),
  load(id) {
    if (id !== `\0${NAME}`) return null;
    const [warp] = elements();
    if (!warp) throw new Error('there are no elements');
    const properties = settable(warp).filter((one) => 'kind' in one);
    const names = properties.map(({ name }) => `'${name}'`);
    const events = warp.events.map(({ name }) => `  ${reactListener(name)}: '${name}',`);
    return `export const PROPERTIES = [${names.join(', ')}];\nexport const EVENTS = {\n${events.join('\n')}\n};\n`;
  },
});
