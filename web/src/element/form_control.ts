/** The element as a control of a form: it submits the project as JSON, under its name. */
import type { Project } from '../document/project';

const MISSING = 'Open a picture.';

export class FormControl {
  readonly #element: HTMLElement;
  readonly #project: () => Project | null;
  readonly #internals: ElementInternals;
  #listening = new AbortController();

  /** @param project the project to submit; null without a picture. */
  constructor(element: HTMLElement, project: () => Project | null) {
    this.#element = element;
    this.#project = project;
    this.#internals = element.attachInternals();
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

  /** Called when the element gets another form. The project is written when it is submitted, not at each step. */
  associate(form: HTMLFormElement | null): void {
    this.#listening.abort();
    this.#listening = new AbortController();
    const submit = ({ formData }: FormDataEvent) => {
      const [name, project] = [this.#element.getAttribute('name'), this.#project()];
      if (name && project && !this.#element.matches(':disabled'))
        formData.append(name, JSON.stringify(project));
    };
    form?.addEventListener('formdata', submit, { signal: this.#listening.signal });
  }

  /** @param isMissing Whether there is no picture where one is required. */
  validate(isMissing: boolean): void {
    if (isMissing) this.#internals.setValidity({ valueMissing: true }, MISSING);
    else this.#internals.setValidity({});
  }
}
