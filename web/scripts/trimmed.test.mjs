import { describe, expect, it } from 'vitest';
import { trimmedGlue, trimmedMarkup, trimmedShader, trimmedSheets } from './trimmed.mjs';

describe('trimmed', () => {
  it('only removes comments and indentation of style sheets', () => {
    const code = `/** Stays. */
const sheet = css\`
  /* Goes,
     all of it. */
  a {
    content: '   '; /* too */
    top: \${TOP}px;
  }
\`;
  const indented = 1;`;
    expect(trimmedSheets(code)).toBe(`/** Stays. */
const sheet = css\`
a {
content: '   ';
top: \${TOP}px;
}
\`;
  const indented = 1;`);
  });

  it('removes indentation of markup, and keeps its words apart', () => {
    const code = "const words = html`<p>\n    Two\n    <b>words</b>\n  </p>`;\n  const a = ' b ';";
    expect(trimmedMarkup(code)).toBe("const words = html`<p>\nTwo\n<b>words</b>\n</p>`;\nconst a = ' b ';");
  });

  it('removes lines of comment and indentation of shaders', () => {
    const shader =
      '#version 300 es\n// What it is.\nvoid main() {\n  // Why.\n  colour = vec4(1.0) / 2.0;\n}\n';
    expect(trimmedShader(shader)).toBe('#version 300 es\nvoid main() {\ncolour = vec4(1.0) / 2.0;\n}\n');
  });

  it('lets bundlers drop unused classes of the glue', () => {
    const glue = `class A {
    free() {}
}
if (Symbol.dispose) A.prototype[Symbol.dispose] = A.prototype.free;
const AFinalization = (typeof FinalizationRegistry === 'undefined')
    ? {}
    : new FinalizationRegistry(ptr => free(ptr));
`;
    expect(trimmedGlue(glue)).toBe(`class A {
    free() {}
}
const AFinalization = (typeof FinalizationRegistry === 'undefined')
    ? {}
    : /* @__PURE__ */ new FinalizationRegistry(ptr => free(ptr));
`);
  });
});
