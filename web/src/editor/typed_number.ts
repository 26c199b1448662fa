/**
 * Numbers as people, input methods and locales write them.
 *
 * Full-width and Arabic digits, all kinds of minus, a decimal comma, and thousands in groups count. A text that
 * can be read in two ways is read as the editor writes it: `1,024` is a thousand, `1.024` is about one.
 */

/** Full-width signs, from `！` to `～`, follow the order of ASCII. */
const FULL_WIDTH = /[\uff01-\uff5e]/g;
const FULL_WIDTH_OFFSET = 0xfee0;
/** Arabic and Persian digits. */
const ARABIC = /[\u0660-\u0669\u06f0-\u06f9]/g;
/** Hyphens, dashes, the minus sign, and the long vowel that Japanese keyboards have in the place of a minus. */
const MINUS = /[\u2010-\u2015\u2212\ufe63\u30fc]/g;
/** The ideographic full stop, and the Arabic decimal separator. */
const POINT = /[\u3002\u066b]/g;
/** The ideographic comma, and the Arabic thousands separator and comma. */
const COMMA = /[\u3001\u066c\u060c]/g;
/** Marks of the direction of the text. */
const INVISIBLE = /\p{Cf}/gu;
/** Between thousands. No-break and thin spaces are `\s` too. */
const GAP = /(?<=\d)[\s'\u2019](?=\d{3}(?!\d))/g;
const COMMA_GROUPS = /^[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/;
const POINT_GROUPS = /^[+-]?[1-9]\d{0,2}((\.\d{3})+,\d*|(\.\d{3}){2,})$/;
const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** Returns the number that a text is, or `NaN`. */
export function typedNumber(text: string): number {
  const plain = text
    .replace(FULL_WIDTH, (sign) => String.fromCharCode(sign.charCodeAt(0) - FULL_WIDTH_OFFSET))
    .replace(ARABIC, (digit) => String(digit.charCodeAt(0) & 0xf))
    .replace(INVISIBLE, '')
    .replace(MINUS, '-')
    .replace(POINT, '.')
    .replace(COMMA, ',')
    .trim()
    .replace(/^([+-])\s+/, '$1')
    .replace(GAP, '');
  const grouped = COMMA_GROUPS.test(plain) ? ',' : POINT_GROUPS.test(plain) ? '.' : '';
  const decimal = (grouped ? plain.replaceAll(grouped, '') : plain).replace(',', '.');
  return DECIMAL.test(decimal) ? Number(decimal) : Number.NaN;
}
