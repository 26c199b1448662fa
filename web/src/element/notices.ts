/**
 * What the editor says: notices, texts for screen readers, progress. A notice that disappears by itself covers a notice
 * that waits for an answer, and does not replace it.
 */
import { isEngineFailure } from '../compute/errors';
import type { Notice, Progress } from '../ui/model';
import type { Emit } from './events';
import { isAbort } from './latest';
import { refusalWords } from './wording';

export interface NoticesHost {
  changed(): void;
  readonly emit: Emit;
  /** Whether people may run the action of a notice. */
  readonly answerable: boolean;
  /** Only errors are shown. */
  readonly playing: boolean;
  /** Solves what the solver has failed at; null if there is nothing. */
  readonly again: (() => void) | null;
}

/** Long enough to read a sentence twice. */
const PASSING_MS = 6000;
/** Long enough to decide, too. */
const ANSWER_MS = 15_000;

/** What is said about a step, with what was said about it before. */
function joined(before: Notice | null, notice: Notice): Notice {
  if (!before?.ofStep || !notice.ofStep) return notice;
  if (before.text.includes(notice.text)) return before;
  return { ...before, ...notice, text: `${before.text} ${notice.text}` };
}

export class Notices {
  readonly #host: NoticesHost;
  /** A notice with an action, an error, and a notice that disappears by itself: the last one present is shown. */
  #offer: Notice | null = null;
  #error: Notice | null = null;
  #passing: Notice | null = null;
  #announcement = '';
  /** Current operations, the newest last. */
  #works: readonly Progress[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(host: NoticesHost) {
    this.#host = host;
  }

  get notice(): Notice | null {
    return this.#host.playing ? this.#error : (this.#passing ?? this.#error ?? this.#offer);
  }

  get announcement(): string {
    return this.#announcement;
  }

  /** The newest current operation. */
  get progress(): Progress | null {
    return this.#works.at(-1) ?? null;
  }

  /** Shows a notice. Its action dismisses it; without an action, anything but an error disappears by itself. */
  notify(given: Notice): void {
    const notice = joined(this.#passing, given);
    this.#pass();
    const { kind, action, passes = !action } = notice;
    const run = () => {
      if (kind === 'info' && !action?.reads && !this.#host.answerable) return;
      this.dismiss();
      action?.run();
    };
    const shown = action ? { ...notice, action: { ...action, run } } : notice;
    if (!passes) this.#offer = shown;
    else if (kind === 'error') this.#error = shown;
    else {
      this.#passing = shown;
      this.linger(false);
    }
    this.#host.changed();
  }

  /** Keeps a notice that would disappear by itself, as long as a pointer or the focus is on it. */
  linger(on: boolean): void {
    clearTimeout(this.#timer);
    if (on || !this.#passing) return;
    this.#timer = setTimeout(() => this.dismiss(), this.#passing.action ? ANSWER_MS : PASSING_MS);
  }

  /** Another step was done, undone or redone: closes what was said about the one before. */
  stepped(): void {
    if (!this.#passing?.ofStep) return;
    this.#pass();
    this.#host.changed();
  }

  /** Closes the shown notice. */
  dismiss(): void {
    const { notice } = this;
    if (notice === this.#passing) this.#pass();
    else if (notice === this.#error) this.#error = null;
    else this.#offer = null;
    this.#host.changed();
  }

  /** Closes all notices. */
  clear(): void {
    this.#pass();
    this.#error = null;
    this.#offer = null;
    this.#host.changed();
  }

  /** The solver works: closes the error that can be tried again. */
  solved(): void {
    if (this.#error?.action) this.#error = null;
  }

  #pass(): void {
    clearTimeout(this.#timer);
    this.#passing = null;
  }

  /**
   * Shows an error as a notice, in words of the editor, and emits it as it is. One of the solver itself can be tried again.
   * Ignores AbortErrors: overtaken work is no error.
   */
  report(thrown: unknown): void {
    const error = thrown instanceof Error ? thrown : new Error(String(thrown));
    if (isAbort(error)) return;
    const run = isEngineFailure(error) ? this.#host.again : null;
    const action = run && ({ action: { label: 'Try again', run }, passes: true } as const);
    this.notify({ kind: 'error', text: refusalWords(error), ...action });
    this.#host.emit('error', error);
  }

  /** Announces a text. Screen readers read only changes: a repeated text gets a trailing space that is not read. */
  say(text: string): void {
    this.#announcement = this.#announcement === text ? `${text}\u00a0` : text;
    this.#host.changed();
  }

  dispose(): void {
    clearTimeout(this.#timer);
  }

  /** Shows a long operation; `cancel` is null if it cannot be cancelled. Returns a function that ends the display. */
  begin(label: string, cancel: (() => void) | null = null): () => void {
    const work = { label, cancel };
    this.#progress([...this.#works, work]);
    return () => this.#progress(this.#works.filter((other) => other !== work));
  }

  #progress(works: readonly Progress[]): void {
    const last = this.progress;
    this.#works = works;
    if (this.progress === last) return;
    this.#host.emit('progress', { label: this.progress?.label ?? null });
    this.#host.changed();
  }
}
