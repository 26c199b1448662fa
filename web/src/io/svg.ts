/**
 * A figure of the page as a self-contained SVG file.
 *
 * Style sheets stay behind in the page, so the file gets their values as attributes of its elements. Comments and
 * classes are left out.
 */

/** The properties that figures use, with their initial values. These are left out. */
const PROPERTIES: Readonly<Record<string, string>> = {
  fill: 'rgb(0, 0, 0)',
  stroke: 'none',
  'stroke-width': '1px',
  'stroke-dasharray': 'none',
  'stroke-linecap': 'butt',
  'stroke-linejoin': 'miter',
};

const OF_TEXT = ['font-family', 'font-size', 'font-weight'];

/** A mixed colour as browsers compute it: numbers from 0 to 1, and perhaps an opacity. */
const MIXED = /^color\(srgb ([\d.e-]+) ([\d.e-]+) ([\d.e-]+)(?: \/ ([\d.e-]+))?\)$/;

/** @param figure is on the page, so that its styles are known. */
export function svgText(figure: SVGSVGElement): string {
  const copy = figure.cloneNode(true) as SVGSVGElement;
  const originals = [figure, ...figure.querySelectorAll('*')];
  [copy, ...copy.querySelectorAll('*')].forEach((element, at) => {
    const original = originals[at];
    if (original) dress(element, getComputedStyle(original));
  });
  const walker = document.createTreeWalker(copy, NodeFilter.SHOW_COMMENT);
  const comments: ChildNode[] = [];
  while (walker.nextNode()) comments.push(walker.currentNode as ChildNode);
  for (const comment of comments) comment.remove();
  const text = new XMLSerializer().serializeToString(copy).replace(/>\s+</g, '><');
  return `<?xml version="1.0" encoding="UTF-8"?>\n${text}\n`;
}

function dress(element: Element, style: CSSStyleDeclaration): void {
  element.removeAttribute('class');
  if (element.matches('svg, g, title, image')) return;
  for (const [name, initial] of Object.entries(PROPERTIES)) {
    const value = style.getPropertyValue(name);
    if (value !== '' && value !== initial) set(element, name, value);
  }
  if (!element.matches('text, tspan')) return;
  for (const name of OF_TEXT) element.setAttribute(name, style.getPropertyValue(name));
}

/** Sets an attribute. Other programs know mixed colours as three bytes and an opacity. */
function set(element: Element, name: string, value: string): void {
  const [, red, green, blue, opacity] = MIXED.exec(value) ?? [];
  if (red === undefined) {
    element.setAttribute(name, value);
    return;
  }
  const bytes = [red, green, blue].map((part) => Math.round(255 * Number(part)));
  element.setAttribute(name, `rgb(${bytes.join(', ')})`);
  if (opacity !== undefined) element.setAttribute(`${name}-opacity`, opacity);
}
