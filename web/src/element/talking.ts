/** What the editor says: notices that stay until they are answered, words for screen readers, progress. */
import type { Notice, Progress } from '../ui/model';

export interface TalkingHost {
  changed(): void;
  emit(type: string, detail?: unknown): void;
  /** Whether what is under way can be given up. */
  readonly cancellable: boolean;
}

/** Long enough to read a sentence twice. */
const PASSING_MS = 6000;

export class Talking {
  readonly #host: TalkingHost;
  #notice: Notice | null = null;
  #announcement = '';
  #progress: Progress | null = null;
  #passing: ReturnType<typeof setTimeout> | undefined;

  constructor(host: TalkingHost) {
    this.#host = host;
  }

  get notice(): Notice | null {
    return this.#notice;
  }

  get announcement(): string {
    return this.#announcement;
  }

  get progress(): Progress | null {
    return this.#progress;
  }

  /** Shows a notice in place of the one before; answering it closes it, and what needs no answer passes. */
  notify(notice: Notice | null): void {
    clearTimeout(this.#passing);
    const { action, ...plain } = notice ?? {};
    const answer = action && {
      label: action.label,
      run: () => {
        this.notify(null);
        action.run();
      },
    };
    this.#notice = notice && { ...(plain as Notice), ...(answer && { action: answer }) };
    if (notice?.kind === 'info' && !action) this.#passing = setTimeout(() => this.notify(null), PASSING_MS);
    this.#host.changed();
  }

  /** An error as a notice, and as an event for the page. Work overtaken by newer work is no error. */
  report(error: unknown): void {
    if (error instanceof DOMException && error.name === 'AbortError') return;
    this.notify({ kind: 'error', text: error instanceof Error ? error.message : String(error) });
    this.#host.emit('error', error);
  }

  say(text: string): void {
    this.#announcement = text;
    this.#host.changed();
  }

  dispose(): void {
    clearTimeout(this.#passing);
  }

  progressed(label: string | null): void {
    if (label === null && this.#progress === null) return;
    this.#progress = label === null ? null : { label, cancellable: this.#host.cancellable };
    this.#host.emit('progress', { label });
    this.#host.changed();
  }
}
