/** Runs one answer at a time. Of questions that come meanwhile, the latest one is asked next. */
export class Latest {
  readonly #answer: () => Promise<void>;
  readonly #failed: (error: unknown) => void;
  #running = false;
  #wanted = false;

  constructor(answer: () => Promise<void>, failed: (error: unknown) => void) {
    this.#answer = answer;
    this.#failed = failed;
  }

  ask(): void {
    this.#wanted = true;
    if (!this.#running) void this.#run();
  }

  async #run(): Promise<void> {
    this.#running = true;
    try {
      while (this.#wanted) {
        this.#wanted = false;
        await this.#answer();
      }
    } catch (error) {
      this.#failed(error);
    } finally {
      this.#running = false;
    }
  }
}
