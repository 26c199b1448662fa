/** Sentences with symbols of the paper. */
import { html, type TemplateResult } from 'lit-html';

/** A text in which `r_d` and `r_h` are set with an index. */
export const withSymbols = (text: string): readonly (string | TemplateResult)[] =>
  text.split(/r_([dh])/).map((part, k) => (k % 2 === 0 ? part : html`r<sub>${part}</sub>`));
