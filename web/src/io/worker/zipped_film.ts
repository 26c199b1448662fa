/** Films as zip archives: single frames as PNG files, and a sprite sheet with its JSON. */
import { plainPng } from '../encoding';
import type { FilmSettings } from '../filming';
import type { FilmEncoder } from './film_encoder';
import type { FilmOutput } from './film_output';
import { ModuleFilm } from './module_film';
import { PngFile } from './png_file';
import { ZipFile } from './zip_file';

/** Frames as PNG files, `NAME-0000.png` and so on. */
export class FramesFilm implements FilmEncoder {
  readonly #settings: FilmSettings;
  readonly #zip: ZipFile;
  readonly #digits: number;
  #frame = 0;

  constructor(settings: FilmSettings, output: FilmOutput) {
    this.#settings = settings;
    this.#zip = new ZipFile((position, bytes) => output.write(position, bytes));
    this.#digits = Math.max(4, String(settings.frames - 1).length);
  }

  async add(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    const { width, height, name } = this.#settings;
    const png = new PngFile(plainPng(width, height));
    await png.write(rgba);
    const file = new Uint8Array(await (await png.finish()).arrayBuffer());
    const number = String(this.#frame++).padStart(this.#digits, '0');
    await this.#zip.begin(`${name}-${number}.png`)(file, true);
  }

  finish(): Promise<void> {
    return this.#zip.finish();
  }

  dispose(): void {}
}

/** A sprite sheet, and a JSON file in TexturePacker's hash form beside it. */
export class SheetFilm implements FilmEncoder {
  readonly #sheet: ModuleFilm;
  readonly #zip: ZipFile;
  readonly #name: string;

  private constructor(sheet: ModuleFilm, zip: ZipFile, name: string) {
    this.#sheet = sheet;
    this.#zip = zip;
    this.#name = name;
  }

  /** @param encoder see `BeginFilm`. @throws Refused if the sheet would be too large. */
  static async begin(settings: FilmSettings, output: FilmOutput, encoder: string): Promise<SheetFilm> {
    const zip = new ZipFile((position, bytes) => output.write(position, bytes));
    let write: ReturnType<ZipFile['begin']> | null = null;
    // All of it comes at the end.
    const sheet = await ModuleFilm.begin(settings, 'sheet', null, encoder, async (_, bytes) => {
      write ??= zip.begin(`${settings.name}.png`);
      await write(bytes, false);
    });
    const film = new SheetFilm(sheet, zip, settings.name);
    film.#end = async () => write?.(new Uint8Array(), true);
    return film;
  }

  #end: () => Promise<void> = async () => {};

  add(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    return this.#sheet.add(rgba);
  }

  async finish(): Promise<void> {
    const json = new TextEncoder().encode(this.#sheet.json);
    await this.#sheet.finish();
    await this.#end();
    await this.#zip.begin(`${this.#name}.json`)(json, true);
    await this.#zip.finish();
  }

  dispose(): void {
    this.#sheet.dispose();
  }
}
