/** GIF, APNG, WebP and sprite sheets, by the WebAssembly module of the film encoders. It is loaded at first use. */
import { say } from '../../texts/wording';
import type { FilmFormat, FilmSettings } from '../filming';
import init, { Container, FilmWriter } from '../generated/film';
import { colourOf } from './colours';
import type { FilmEncoder } from './film_encoder';
import { Broken, Refused } from './refused';

export type ModuleFormat = Exclude<FilmFormat, 'webm' | 'mp4' | 'frames'>;

const CONTAINERS: Readonly<Record<ModuleFormat, Container>> = {
  gif: Container.Gif,
  apng: Container.Apng,
  webp: Container.WebP,
  sheet: Container.Sheet,
};

let loading: Promise<unknown> | undefined;

/** @throws Refused if the module does not come. A later film tries again. */
async function load(address: string): Promise<void> {
  loading ??= init({ module_or_path: address });
  try {
    await loading;
  } catch {
    loading = undefined;
    throw new Refused(say('errors.writing.reasons.encoderNotLoaded', String(address)));
  }
}

/** Takes pieces of a file in the order in which they were made. */
type Take = (position: number, bytes: Uint8Array<ArrayBuffer>) => Promise<void>;

export class ModuleFilm implements FilmEncoder {
  readonly #writer: FilmWriter;
  readonly #take: Take;

  private constructor(writer: FilmWriter, take: Take) {
    this.#writer = writer;
    this.#take = take;
  }

  /**
   * @param encoder see `BeginFilm`.
   * @throws Refused if the module is not there, or the film too large for its format.
   */
  static async begin(
    settings: FilmSettings,
    format: ModuleFormat,
    picture: Uint8Array | null,
    encoder: string,
    take: Take,
  ): Promise<ModuleFilm> {
    await load(encoder);
    const { width, height, frames, rate, endlessly, background, matte, name } = settings;
    const mixed = background === null ? Uint8Array.from(colourOf(matte)) : undefined;
    const writer = attempt(
      () =>
        new FilmWriter(
          CONTAINERS[format],
          width,
          height,
          frames,
          rate,
          endlessly,
          picture ?? new Uint8Array(),
          mixed,
          `${name}.png`,
          name,
        ),
    );
    return new ModuleFilm(writer, take);
  }

  /** The JSON of a sheet. */
  get json(): string {
    return this.#writer.json ?? '';
  }

  async add(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    attempt(() => this.#writer.add(rgba));
    await this.#drain();
  }

  async finish(): Promise<void> {
    attempt(() => this.#writer.finish());
    await this.#drain();
  }

  dispose(): void {
    try {
      this.#writer.free();
    } catch {
      // It panicked, and its memory is gone with the worker.
    }
  }

  async #drain(): Promise<void> {
    for (let piece = this.#writer.takePiece(); piece; piece = this.#writer.takePiece()) {
      const { position } = piece;
      const bytes = piece.take() as Uint8Array<ArrayBuffer>;
      piece.free();
      await this.#take(position, bytes);
    }
  }
}

/** Calls the module. @throws Refused for its errors; a panic is passed on unchanged. */
function attempt<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw new Broken(TOO_LARGE);
    throw new Refused(
      say('errors.writing.reasons.other', error instanceof Error ? error.message : String(error)),
    );
  }
}

const TOO_LARGE = say('errors.writing.reasons.filmTooLarge');
