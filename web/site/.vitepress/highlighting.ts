/** Highlighted code without inline styles: each kind of token is a class, and `theme/code.css` has the colours. */
import { createCssVariablesTheme, type ShikiTransformer } from 'shiki';

const PREFIX = '--';

/** Colours are variables, one a kind of token. */
export const HIGHLIGHTING = createCssVariablesTheme({ variablePrefix: PREFIX });

const VARIABLE = new RegExp(`^color:var\\(${PREFIX}([\\w-]+)\\)$`);

export const tokensByClass: ShikiTransformer = {
  name: 'tokens-by-class',
  pre({ properties }) {
    delete properties.style;
  },
  span({ properties }) {
    const [, kind] = VARIABLE.exec(String(properties.style ?? '')) ?? [];
    delete properties.style;
    if (kind?.startsWith('token-')) properties.class = kind;
  },
};
