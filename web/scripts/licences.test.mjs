import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { licencesOf } from './licences.mjs';
import { ROOT } from './steps.mjs';

describe('the licences of a build', () => {
  it('are those of bundled packages and linked crates, with their texts', async () => {
    const text = await licencesOf([join(ROOT, 'node_modules/lit-html')]);
    const names = [...text.matchAll(/^## (\S+) \d/gm)].map(([, name]) => name);
    expect(names).toEqual(
      expect.arrayContaining(['exr', 'gif', 'glam', 'lit-html', 'serde_json', 'spade', 'wasm-bindgen']),
    );
    // Used by the command, by tests and by the build; macros.
    for (const other of ['clap', 'encoding_rs', 'proptest', 'vite', 'serde_derive', 'c2warp']) {
      expect(names).not.toContain(other);
    }
    for (const chapter of text.split(/^## (?=\S+ \d)/m).slice(1)) {
      expect(chapter.length, chapter).toBeGreaterThan(300);
      expect(chapter).toMatch(/copyright|licen[cs]e|\(c\)/i);
    }
    expect(text).toMatch(/^# c2warp\n\nMIT License/);
    expect(text).toContain('Copyright (c) 2017 Google LLC');
    // Comes without the text of its licence.
    expect(text).toContain('Copyright (c) the authors of zune-inflate');
    expect(text).toMatch(/^## selectors .*\n\nIts source is at https:.*\n\nMozilla Public License/m);
  });
});
