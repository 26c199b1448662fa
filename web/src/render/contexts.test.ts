import { expect, test } from 'vitest';
import { Contexts, type Drawn } from './contexts';

/** A page with so many drawings, by number. */
class Page {
  readonly #contexts: Contexts;
  readonly #all: Drawn[] = [];
  readonly #awake = new Set<number>();

  constructor(most: number, count: number) {
    this.#contexts = new Contexts(most);
    for (let at = 0; at < count; at++) this.add();
  }

  get awake(): number[] {
    return [...this.#awake].sort((a, b) => a - b);
  }

  add(): void {
    const at = this.#all.length;
    this.#awake.add(at);
    this.#all.push({ sleep: () => this.#awake.delete(at), wake: () => this.#awake.add(at) });
    this.#tell('add', [at]);
  }

  see(...numbers: number[]): void {
    this.#tell('see', numbers);
  }

  lose(...numbers: number[]): void {
    this.#tell('lose', numbers);
  }

  remove(at: number): void {
    this.#awake.delete(at);
    this.#tell('remove', [at]);
  }

  #tell(what: 'add' | 'see' | 'lose' | 'remove', numbers: number[]): void {
    for (const drawn of numbers.map((at) => this.#all[at])) if (drawn) this.#contexts[what](drawn);
  }
}

test('as many as there are contexts stay awake, in sight or not', () => {
  const page = new Page(3, 3);
  page.see(0, 1, 2);
  page.lose(0, 1, 2);
  expect(page.awake).toEqual([0, 1, 2]);
});

test('of more, the first on the page are awake until it is known which are in sight', () => {
  const page = new Page(3, 5);
  expect(page.awake).toEqual([0, 1, 2]);
  page.see(4, 3);
  expect(page.awake).toHaveLength(3);
  expect(page.awake).toEqual(expect.arrayContaining([3, 4]));
});

test('what has been out of sight for longest gives its context back', () => {
  const page = new Page(3, 4);
  page.see(0, 1, 2);
  page.lose(1, 0);
  page.see(3);
  expect(page.awake).toEqual([0, 2, 3]);
  page.see(1);
  expect(page.awake).toEqual([1, 2, 3]);
});

test('nothing in sight is put to sleep, however much there is', () => {
  const page = new Page(2, 4);
  page.see(0, 1, 2, 3);
  expect(page.awake).toEqual([0, 1, 2, 3]);
  page.lose(0);
  expect(page.awake).toEqual([1, 2, 3]);
});

test('what is gone holds no context', () => {
  const page = new Page(2, 2);
  page.see(0, 1);
  page.remove(0);
  page.add();
  page.lose(1);
  expect(page.awake).toEqual([1, 2]);
});
