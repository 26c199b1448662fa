import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { withoutInline } from './policy';

it('inline scripts become files, and inline styles go', () => {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-policy-'));
  try {
    const page =
      '<script id="a">go()</script><script src="b.js"></script><p class="c" style="color: red">x</p>';
    const html = withoutInline(page, folder, '/base/');
    const [, name = ''] =
      /^<script id="a" src="\/base\/(assets\/inline\.\w+\.js)"><\/script>/.exec(html) ?? [];
    expect(readFileSync(join(folder, name), 'utf8')).toBe('go()');
    expect(html).toContain('<script src="b.js"></script><p class="c">x</p>');
  } finally {
    rmSync(folder, { recursive: true });
  }
});
