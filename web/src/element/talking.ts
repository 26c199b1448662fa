/**
 * What the editor says: notices that stay until they are answered, words for screen readers, progress. What passes by itself lies over
 * what waits for an answer, and takes nothing of it away.
 */
import type { Notice, Progress } from '../ui/model';
import type { Emit } from './events';

export interface TalkingHost {
  changed(): void;
  readonly emit: Emit;
  /** Whether people may do what a notice offers. */
  readonly answerable: boolean;
}

/** Long enough to read a sentence twice. */
const PASSING_MS = 6000;

export class Talking {
  readonly #host: TalkingHost;
  /** What offers something, what went wrong, and what passes: the last that there is is shown. */
  #offer: Notice | null = null;
  #error: Notice | null = null;
  #passing: Notice | null = null;
  #announcement = '';
  /** What is under way, the newest last. */
  #works: readonly Progress[] = [];
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(host: TalkingHost) {
    this.#host = host;
  }

  get notice(): Notice | null {
    return this.#passing ?? this.#error ?? this.#offer;
  }

  /** What went wrong and has not been answered. */
  get error(): Notice | null {
    return this.#error;
  }

  get announcement(): string {
    return this.#announcement;
  }

  /** The newest of what is under way. */
  get progress(): Progress | null {
    return this.#works.at(-1) ?? null;
  }

  /** Shows a notice; answering it closes it, and what needs no answer passes. */
  notify({ action, ...plain }: Notice): void {
    this.#pass();
    const run = () => {
      if (!this.#host.answerable) return;
      this.dismiss();
      action?.run();
    };
    if (action) this.#offer = { ...plain, action: { label: action.label, run } };
    else if (plain.kind === 'error') this.#error = plain;
    else {
      this.#passing = plain;
      this.#timer = setTimeout(() => this.dismiss(), PASSING_MS);
    }
    this.#host.changed();
  }

  /** The notice that is shown goes. */
  dismiss(): void {
    if (this.#passing) this.#pass();
    else if (this.#error) this.#error = null;
    else this.#offer = null;
    this.#host.changed();
  }

  /** All of them do. */
  clear(): void {
    this.#pass();
    this.#error = null;
    this.#offer = null;
    this.#host.changed();
  }

  #pass(): void {
    clearTimeout(this.#timer);
    this.#passing = null;
  }

  /** An error as a notice, and as an event for the page. Work overtaken by newer work is no error. */
  report(thrown: unknown): void {
    const error = thrown instanceof Error ? thrown : new Error(String(thrown));
    if (error.name === 'AbortError') return;
    this.notify({ kind: 'error', text: error.message });
    this.#host.emit('error', error);
  }

  /** The same words twice are told apart by a space that is not heard: screen readers read what changes. */
  say(text: string): void {
    this.#announcement = this.#announcement === text ? `${text}\u00a0` : text;
    this.#host.changed();
  }

  dispose(): void {
    clearTimeout(this.#timer);
  }

  /** Something has begun that takes a while, and perhaps can be given up. Returns what ends it. */
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
