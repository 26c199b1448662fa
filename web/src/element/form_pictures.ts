/** Forms that wait until the pictures of their elements are drawn. */

/** An element that may submit a picture. */
export interface FormPicture {
  /** Whether the form submits its picture now. */
  isAsked(): boolean;
  draw(): Promise<File>;
  failed(error: unknown): void;
}

const known = new WeakMap<HTMLFormElement, FormPictures>();

/**
 * The pictures of one form. A submission is held back, and restarted with all pictures. So every listener of a page
 * receives it once, with the pictures in its data.
 */
export class FormPictures {
  readonly #form: HTMLFormElement;
  readonly #members = new Set<FormPicture>();
  /** The pictures of the current submission. */
  #drawn: ReadonlyMap<FormPicture, File> | null = null;
  #isDrawing = false;

  static of(form: HTMLFormElement): FormPictures {
    return known.get(form) ?? new FormPictures(form);
  }

  private constructor(form: HTMLFormElement) {
    this.#form = form;
    known.set(form, this);
    // In the capture phase, before the listeners of the page.
    form.addEventListener('submit', (event) => this.#hold(event), { capture: true });
  }

  /** @param signal ends the membership. */
  add(member: FormPicture, signal: AbortSignal): void {
    this.#members.add(member);
    signal.addEventListener('abort', () => this.#members.delete(member));
  }

  /** The picture in the current submission; null without one. */
  drawnBy(member: FormPicture): File | null {
    return this.#drawn?.get(member) ?? null;
  }

  #hold(event: SubmitEvent): void {
    if (event.target !== this.#form || this.#drawn) return;
    const asked = [...this.#members].filter((member) => member.isAsked());
    if (asked.length === 0 && !this.#isDrawing) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!this.#isDrawing) void this.#submit(asked, event.submitter);
  }

  async #submit(asked: readonly FormPicture[], submitter: HTMLElement | null): Promise<void> {
    this.#isDrawing = true;
    try {
      const drawn = await Promise.all(
        asked.map(async (member) => [member, await drawnOrTold(member)] as const),
      );
      this.#drawn = new Map(drawn);
      // The form makes its data before this returns.
      if (this.#form.isConnected) this.#form.requestSubmit(submitter);
    } catch {
      // Already reported. Nothing is submitted.
    } finally {
      this.#drawn = null;
      this.#isDrawing = false;
    }
  }
}

async function drawnOrTold(member: FormPicture): Promise<File> {
  try {
    return await member.draw();
  } catch (error) {
    member.failed(error);
    throw error;
  }
}
