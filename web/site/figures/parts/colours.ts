/** The colours of the figures, which `figure.css` defines for both themes. */

export type Rgb = readonly [red: number, green: number, blue: number];

const NAMES = ['ink', 'faint', 'line', 'shape', 'paper', 'blue', 'pink', 'green', 'red'] as const;
export type ColourName = (typeof NAMES)[number];
export type Colours = Readonly<Record<ColourName, Rgb>>;

/** The colours of the present theme. */
export function coloursOf(element: Element): Colours {
  const style = getComputedStyle(element);
  const pairs = NAMES.map((name) => [name, parsed(style.getPropertyValue(`--figure-${name}`))] as const);
  return Object.fromEntries(pairs) as Record<ColourName, Rgb>;
}

/** @param text As `#rrggbb`, or `#rgb` from a tool that shortens style sheets. */
function parsed(text: string): Rgb {
  const digits = text.trim().slice(1);
  const whole = digits.length === 3 ? digits.replace(/./g, '$&$&') : digits;
  const value = Number.parseInt(whole, 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

export const css = (colour: Rgb, opacity = 1): string => `rgb(${colour.join(' ')} / ${opacity})`;

/** An opaque pixel of an image, as a number in the byte order of nearly all machines. */
export const packed = ([red, green, blue]: Rgb): number => 0xff000000 + (blue << 16) + (green << 8) + red;

/** @param part Of the second colour, from 0 to 1. */
export const mixed = (one: Rgb, other: Rgb, part: number): Rgb => [
  one[0] + (other[0] - one[0]) * part,
  one[1] + (other[1] - one[1]) * part,
  one[2] + (other[2] - one[2]) * part,
];

/** Calls back when the theme of the page changes. Returns a function that ends that. */
export function onTheme(changed: () => void): () => void {
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributeFilter: ['class'] });
  return () => observer.disconnect();
}
