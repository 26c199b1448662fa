/** The element as a control of a form: it submits the project as JSON, or the warped picture, under its name. */
import type { Project } from '../document/project';
import { type FormPicture, FormPictures } from './form_pictures';

/** What a form may submit. */
export const SUBMITTED = ['project', 'picture'] as const;

/** The interface of the element to its form. */
export interface Submitting {
  readonly node: HTMLElement & { readonly submits: (typeof SUBMITTED)[number] };
  /** Null without a picture. */
  project(): Project | null;
  /** The warped picture, drawn now. */
  picture(): Promise<File>;
  failed(error: unknown): void;
}

export class FormControl implements FormPicture {
  readonly #element: Submitting;
  readonly #internals: ElementInternals;
  #listening = new AbortController();

  constructor(element: Submitting) {
    this.#element = element;
    this.#internals = element.node.attachInternals();
  }

  get form(): HTMLFormElement | null {
    return this.#internals.form;
  }

  get validity(): ValidityState {
    return this.#internals.validity;
  }

  get validationMessage(): string {
    return this.#internals.validationMessage;
  }

  checkValidity(): boolean {
    return this.#internals.checkValidity();
  }

  reportValidity(): boolean {
    return this.#internals.reportValidity();
  }

  /** Called when the element gets another form. The value is computed on submission, not at each step. */
  associate(form: HTMLFormElement | null): void {
    this.#listening.abort();
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    form?.addEventListener('formdata', ({ formData }) => this.#append(formData), { signal });
    if (form) FormPictures.of(form).add(this, signal);
  }

  /** @param missing the message that a required picture is missing; null if it is not. */
  validate(missing: string | null): void {
    if (missing !== null) this.#internals.setValidity({ valueMissing: true }, missing);
    else this.#internals.setValidity({});
  }

  isAsked(): boolean {
    return this.#submitsPicture && this.#name !== null && this.#element.project() !== null;
  }

  draw(): Promise<File> {
    return this.#element.picture();
  }

  failed(error: unknown): void {
    this.#element.failed(error);
  }

  get #name(): string | null {
    const { node } = this.#element;
    return node.matches(':disabled') ? null : node.getAttribute('name') || null;
  }

  get #submitsPicture(): boolean {
    return this.#element.node.submits === 'picture';
  }

  #append(data: FormData): void {
    const [name, project] = [this.#name, this.#element.project()];
    if (!name || !project) return;
    if (!this.#submitsPicture) data.append(name, JSON.stringify(project));
    else {
      const drawn = this.form && FormPictures.of(this.form).drawnBy(this);
      if (drawn) data.append(name, drawn);
    }
  }
}
