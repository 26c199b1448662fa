/** The controls of figures: sliders, switches, numbers and legends. */
import type { ColourName } from './colours';
import { element } from './elements';

let ids = 0;

export interface SliderOptions {
  readonly label: string;
  readonly range: readonly [least: number, most: number];
  readonly step: number;
  readonly value: number;
  readonly shown?: (value: number) => string;
  readonly moved: () => void;
}

export class Slider {
  readonly element: HTMLElement;
  readonly #input: HTMLInputElement;
  readonly #output: HTMLOutputElement;
  readonly #shown: (value: number) => string;

  constructor({ label, range: [min, max], step, value, shown = String, moved }: SliderOptions) {
    const id = `figure-slider-${ids++}`;
    this.#shown = shown;
    this.#input = element('input', {
      type: 'range',
      id,
      min: String(min),
      max: String(max),
      step: String(step),
      value: String(value),
    });
    this.#output = element('output', {}, shown(value));
    this.#output.htmlFor.add(id);
    this.#input.addEventListener('input', () => {
      this.#output.textContent = shown(this.value);
      moved();
    });
    this.element = element(
      'div',
      { className: 'slider' },
      element('label', { htmlFor: id }, label),
      this.#output,
      this.#input,
    );
  }

  get value(): number {
    return this.#input.valueAsNumber;
  }

  set value(value: number) {
    this.#input.valueAsNumber = value;
    this.#output.textContent = this.#shown(value);
  }

  set most(most: number) {
    this.#input.max = String(most);
    this.value = Math.min(this.value, most);
  }
}

/** A switch with its label. */
export function checkbox(label: string, checked: boolean, changed: (on: boolean) => void): HTMLElement {
  const input = element('input', { type: 'checkbox', checked });
  input.addEventListener('change', () => changed(input.checked));
  return element('label', { className: 'switch' }, input, label);
}

/** One choice of several. */
export function choice(
  title: string,
  names: readonly string[],
  chosen: number,
  changed: (index: number) => void,
): HTMLElement {
  const group = `figure-choice-${ids++}`;
  const options = names.map((name, index) => {
    const input = element('input', { type: 'radio', name: group, checked: index === chosen });
    input.addEventListener('change', () => changed(index));
    return element('label', { className: 'switch' }, input, name);
  });
  return element('fieldset', { className: 'choice' }, element('legend', {}, title), ...options);
}

/** Names with numbers, which `set` replaces. */
export class Numbers {
  readonly element = element('dl', { className: 'numbers' });
  readonly #values: HTMLElement[];

  constructor(names: readonly (string | Node)[]) {
    this.#values = names.map((name) => {
      const value = element('dd');
      this.element.append(element('div', {}, element('dt', {}, name), value));
      return value;
    });
  }

  set(...values: readonly string[]): void {
    for (const [index, value] of values.entries()) {
      const shown = this.#values[index];
      if (shown && shown.textContent !== value) shown.textContent = value;
    }
  }
}

export interface LegendEntry {
  readonly colour: ColourName;
  readonly look: 'line' | 'dashed' | 'dot' | 'area';
  readonly meaning: string | Node;
}

export const legend = (...entries: readonly LegendEntry[]): HTMLElement =>
  element(
    'ul',
    { className: 'legend' },
    ...entries.map(({ colour, look, meaning }) =>
      element('li', {}, element('span', { className: `mark ${look} ${colour}` }), meaning),
    ),
  );

/** A sentence that is read out when it changes. */
export const sentence = (): HTMLElement => element('p', { className: 'sentence', role: 'status' });

export const pixels = (length: number): string => `${Math.round(length)} px`;
