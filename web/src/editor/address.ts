/** Addresses that people give: typed, pasted or dropped, as text or as a part of HTML. */

/** Addresses in attributes are escaped. */
const ENTITIES: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };

/** The one address that a text consists of; null if it cannot lead to a file. */
export function addressIn(text: string): string | null {
  const address = text.trim();
  return /^(https?:\/\/[^\s/]\S*|data:image\/\S+)$/i.test(address) ? address : null;
}

/** The address of the first picture in HTML; null if there is none. */
export function pictureInHtml(html: string): string | null {
  for (const [tag] of html.matchAll(/<img\b[^>]*>/gi)) {
    const [, quoted, single, bare] = /\ssrc\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"'>]+))/i.exec(tag) ?? [];
    const source = quoted ?? single ?? bare;
    const address = source === undefined ? null : addressIn(unescaped(source));
    if (address) return address;
  }
  return null;
}

const unescaped = (text: string): string =>
  text.replace(/&(amp|lt|gt|quot|#39);/g, (_, name: string) => ENTITIES[name] ?? '');

/** The first address in a list of the type `text/uri-list`; null if there is none. */
export function addressInList(list: string): string | null {
  const lines = list.split(/\r?\n/).filter((line) => !line.startsWith('#'));
  return lines.map(addressIn).find((address) => address !== null) ?? null;
}

/** Whether an address leads to a project by its name. */
export const namesProject = (address: string): boolean =>
  /^https?:/i.test(address) && /\.json$/i.test(address.split(/[?#]/)[0] ?? '');

/** The last part of an address, as a name for people. */
export function nameIn(address: string): string {
  if (/^data:/i.test(address)) return 'picture';
  const path = address.split(/[?#]/)[0]?.replace(/\/+$/, '') ?? '';
  const last = path.split('/').at(-1) ?? '';
  try {
    return decodeURIComponent(last) || address;
  } catch {
    // A stray percent sign.
    return last;
  }
}
