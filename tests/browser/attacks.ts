/** Attacks on the editor by its surroundings: how often, and where each begins. */
import { randomOf } from '../../web/src/editor/random';

/** How often an attack is made: `npm run test:long` has all of them. */
export const times = (all: number, few: number): number => (process.env.LONG_TESTS ? all : few);

/** The same random numbers in every run. @param name of the attack. */
export const randomIn = (name: string): (() => number) =>
  randomOf([...name].reduce((sum, character) => (sum * 31 + character.charCodeAt(0)) | 0, 7));
