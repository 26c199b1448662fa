import { describe, expect, it } from 'vitest';
import { notesOf, otherVersions, repositoryOf, withAbsoluteLinks } from './release_notes.mjs';

const CHANGELOG = `# Changelog

## [Unreleased]

- Later.

## [1.2.0] - 2027-01-31

### Added

- A thing.

## [1.1.0] - unreleased

- Older.

[1.2.0]: https://example.org/1.2.0
`;

describe('notes of a version', () => {
  it('are its section of the changelog with its date', () => {
    expect(notesOf(CHANGELOG, '1.2.0')).toEqual({ date: '2027-01-31', notes: '### Added\n\n- A thing.' });
  });

  it('have no date before the release, and end before definitions of links', () => {
    expect(notesOf(CHANGELOG, '1.1.0')).toEqual({ date: undefined, notes: '- Older.' });
  });

  it('are missing for another version, or an empty section', () => {
    expect(notesOf(CHANGELOG, '1.2')).toBeUndefined();
    expect(notesOf(CHANGELOG, '1x2.0')).toBeUndefined();
    expect(notesOf('## [1.0.0]\n\n## [0.9.0]\n- Text.', '1.0.0')).toBeUndefined();
  });
});

describe('versions', () => {
  const files = {
    package: '{ "version": "1.2.0" }',
    lock: '{ "version": "1.2.0", "packages": { "": { "version": "1.2.0" } } }',
    cargo: `[workspace.package]
version = "1.2.0"
edition = "2024"

[workspace.dependencies]
c2warp = { path = "wasm/core", version = "1.2.0" }
clap = { version = "4.6", features = ["derive"] }
`,
  };

  it('that agree are not listed', () => {
    expect(otherVersions('1.2.0', files)).toEqual([]);
  });

  it('that differ are listed with their places', () => {
    const older = {
      ...files,
      lock: '{ "version": "1.1.0" }',
      cargo: files.cargo.replaceAll('1.2.0', '1.1.0'),
    };
    expect(otherVersions('1.2.0', older)).toEqual([
      'package-lock.json: version is 1.1.0, not 1.2.0',
      'package-lock.json: packages[""].version is missing, not 1.2.0',
      'Cargo.toml: workspace.package.version is 1.1.0, not 1.2.0',
      'Cargo.toml: c2warp is 1.1.0, not 1.2.0',
    ]);
  });
});

describe('a readme elsewhere', () => {
  const absolute = (/** @type {string} */ text) =>
    withAbsoluteLinks(text, 'https://example.org/a/b', '1.0.0');

  it('links to pages and pictures of the version', () => {
    expect(absolute('[the\nmanual](web/a.md#keys) ![a picture](b.png)')).toBe(
      '[the\nmanual](https://example.org/a/b/blob/v1.0.0/web/a.md#keys) ' +
        '![a picture](https://example.org/a/b/raw/v1.0.0/b.png)',
    );
    expect(absolute('<img\nsrc="a.png" /> <source srcset="b.png" />')).toBe(
      '<img\nsrc="https://example.org/a/b/raw/v1.0.0/a.png" /> ' +
        '<source srcset="https://example.org/a/b/raw/v1.0.0/b.png" />',
    );
  });

  it('keeps anchors and addresses', () => {
    const text =
      '[a](#anchor) [b](https://example.org) [c](mailto:a@example.org) <img src="https://example.org" />';
    expect(absolute(text)).toBe(text);
  });

  it('takes the address from either form of the key', () => {
    expect(repositoryOf({ repository: { url: 'git+https://example.org/a/b.git' } })).toBe(
      'https://example.org/a/b',
    );
    expect(repositoryOf({ repository: 'https://example.org/a/b' })).toBe('https://example.org/a/b');
    expect(repositoryOf({})).toBeUndefined();
  });
});
