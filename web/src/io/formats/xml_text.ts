/**
 * The text of an XML file in the encoding that it declares (XML 1.0, appendix F). Names are those of the Encoding
 * Standard. `wasm/cli/src/picture/encoding.rs` reads files alike.
 */
import { latin } from './latin';

/** Decodes a file as text. Returns the declared encoding if it is unknown, or does not match the bytes. */
export type XmlText = { readonly text: string } | { readonly unreadableAs: string };

const MARKS: readonly (readonly [bytes: RegExp, encoding: string])[] = [
  [/^ï»¿/, 'utf-8'],
  [/^(?:ÿþ|[<\s]\0)/, 'utf-16le'],
  [/^(?:þÿ|\0[<\s])/, 'utf-16be'],
];

/** Bytes that hold the declaration. */
const START = 1024;

const DECLARED = /^<\?xml[^>]*?\sencoding\s*=\s*(?:"([^">]*)"|'([^'>]*)')/;

/** The text without the declaration of its encoding, which is true of the file alone. */
export function xmlText(bytes: ArrayBuffer): XmlText {
  const start = latin(new DataView(bytes), 0, START);
  const [, marked] = MARKS.find(([mark]) => mark.test(start)) ?? [];
  const [, double, single] = DECLARED.exec(start) ?? [];
  const label = marked ?? double ?? single ?? 'utf-8';
  try {
    const text = decoderOf(label, marked !== undefined).decode(bytes);
    return { text: text.replace(/^(<\?xml[^>]*?)\s+encoding\s*=\s*(?:"[^">]*"|'[^'>]*')/, '$1') };
  } catch {
    return { unreadableAs: label };
  }
}

/** @throws RangeError for an unknown label. */
function decoderOf(label: string, isMarked: boolean): TextDecoder {
  const { encoding } = new TextDecoder(label);
  // A file whose declaration can be read byte by byte is not in UTF-16.
  const isUtf8 = !isMarked && encoding.startsWith('utf-16');
  return new TextDecoder(isUtf8 ? 'utf-8' : encoding, { fatal: true });
}
