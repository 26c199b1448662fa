/** Notes and versions of a release, and links that work outside the repository. */

/** @param {string} text */
const escaped = (text) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&');

/**
 * The notes of a version, without their heading; undefined if the changelog has none.
 * @param {string} changelog
 * @param {string} version
 * @returns {{ date: string | undefined, notes: string } | undefined} The date as YYYY-MM-DD.
 */
export function notesOf(changelog, version) {
  const heading = new RegExp(`^## \\[${escaped(version)}\\](.*)$`, 'm').exec(changelog);
  if (!heading) return undefined;
  const rest = changelog.slice(heading.index + heading[0].length);
  // Definitions of links end the last section.
  const end = rest.search(/^(## |\[[^\]]+\]: )/m);
  const notes = (end < 0 ? rest : rest.slice(0, end)).trim();
  if (notes === '') return undefined;
  return { date: /\d{4}-\d{2}-\d{2}/.exec(heading[1] ?? '')?.[0], notes };
}

/**
 * The versions that differ from the wanted one, each with its place.
 * @param {string} wanted
 * @param {{ package: string, lock: string, cargo: string }} files The texts of `package.json`, `package-lock.json` and
 * the workspace's `Cargo.toml`.
 */
export function otherVersions(wanted, files) {
  const lock = JSON.parse(files.lock);
  const workspace = /^\[workspace\.package\][^[]*?^version = "([^"]+)"/ms.exec(files.cargo)?.[1];
  const crates = files.cargo.matchAll(/^([\w-]+) = \{ path = "[^"]+", version = "([^"]+)"/gm);
  /** @type {[place: string, version: string | undefined][]} */
  const found = [
    ['package.json: version', JSON.parse(files.package).version],
    ['package-lock.json: version', lock.version],
    ['package-lock.json: packages[""].version', lock.packages?.['']?.version],
    ['Cargo.toml: workspace.package.version', workspace],
    ...[...crates].map(
      ([, name, version]) => /** @type {[string, string]} */ ([`Cargo.toml: ${name}`, version]),
    ),
  ];
  return found
    .filter(([, version]) => version !== wanted)
    .map(([place, version]) => `${place} is ${version ?? 'missing'}, not ${wanted}`);
}

/** Links and pictures of Markdown and HTML, apart from anchors and addresses. */
const LOCAL =
  /(!?)\[((?:\[[^\]]*\]|[^[\]])*)\]\((?!#|[a-z]+:)([^)\s]+)\)|\b(src|srcset)="(?![a-z]+:)([^"]+)"/g;

/**
 * Markdown whose links lead into a repository, for pages that show it elsewhere.
 * @param {string} markdown
 * @param {string} repository An address like `https://host/owner/name`.
 * @param {string} version
 */
export function withAbsoluteLinks(markdown, repository, version) {
  const page = `${repository}/blob/v${version}/`;
  const raw = `${repository}/raw/v${version}/`;
  return markdown.replaceAll(LOCAL, (_, mark, text, target, attribute, source) => {
    if (attribute) return `${attribute}="${raw}${source}"`;
    return `${mark}[${text}](${mark ? raw : page}${target})`;
  });
}

/**
 * The address of the repository in a `package.json`, without `git+` and `.git`.
 * @param {{ repository?: string | { url?: string } }} manifest
 */
export function repositoryOf({ repository }) {
  const url = typeof repository === 'string' ? repository : repository?.url;
  return url?.replace(/^git\+/, '').replace(/\.git$/, '');
}
