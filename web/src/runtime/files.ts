/** Reads opened files, and saves exported ones. */

import type { Project } from '../document/project';
import { projectText } from '../document/project_text';
import type { EditorEffect, ProjectSource } from '../editor/effects';
import type { Dispatch, EventOf } from '../editor/events';
import { EXPORT_FORMATS, type PixelFormat } from '../editor/export_choices';
import type { NamedFile, Picture } from '../editor/picture';
import { asError } from '../error';
import { type FetchOptions, fetchFile, fileName } from '../io/address';
import { openFile, saveFile } from '../io/files';
import { textChunk, textOfFile } from '../io/png_text';
import { readBytes } from '../io/read';
import { bentFile } from './bent_file';
import { joinedProject, KEYWORD, splitProject } from './carried';
import { writtenFile } from './exporting';
import type { ExportFollowing } from './exports';
import { type Pictures, withFileName } from './pictures';
import type { Solver } from './solver';

type ReadOrder = Extract<EditorEffect, { readonly type: 'read' }>;
type ExportOrder = Extract<EditorEffect, { readonly type: 'export' }>;

export class Files {
  readonly #dispatch: Dispatch;
  readonly #pictures: Pictures;
  readonly #solver: Solver;
  readonly #reads = new Map<number, AbortController>();

  constructor(dispatch: Dispatch, pictures: Pictures, solver: Solver) {
    this.#dispatch = dispatch;
    this.#pictures = pictures;
    this.#solver = solver;
  }

  /**
   * Reads a picture, a project, or both.
   *
   * @param credentials whether requests to other origins carry cookies.
   */
  async read(
    { id, pictures: sources, project: given, inside }: ReadOrder,
    credentials: RequestCredentials,
  ): Promise<void> {
    const controller = new AbortController();
    this.#reads.set(id, controller);
    const { signal } = controller;
    const options = { signal, credentials };
    try {
      const files = await Promise.all(
        sources.map((source) => (typeof source === 'string' ? fetched(source, options) : source)),
      );
      const { project, picture: own } =
        given && !signal.aborted ? await this.#project(given, options) : NO_PROJECT;
      if (signal.aborted) return;
      const pictures = files.length > 0 ? files : own ? [own] : [];
      const { picture, source } =
        pictures.length > 0 ? await this.#firstPicture(pictures, signal) : { picture: null, source: null };
      const read =
        picture && inside && !project
          ? await this.#inside(picture, signal)
          : { picture, project, carried: null };
      if (read.picture && signal.aborted) this.#pictures.drop(read.picture);
      if (signal.aborted) return;
      if (read.picture) this.#pictures.handOver(read.picture);
      this.#dispatch({ type: 'read-ended', id, source, ...read });
    } catch (error) {
      if (!signal.aborted) this.#dispatch({ type: 'read-failed', id, error: asError(error) });
    } finally {
      this.#reads.delete(id);
    }
  }

  /** Reads the project in a picture: with the picture that it holds, if any. */
  async #inside(
    picture: Picture,
    signal: AbortSignal,
  ): Promise<Pick<EventOf<'read-ended'>, 'picture' | 'project' | 'carried'>> {
    try {
      const text = await textOfFile(picture.file as Blob, KEYWORD);
      if (text === null) return { picture, project: null, carried: null };
      const { project, picture: own } = await this.#parsed(text);
      if (!own) return { picture, project: null, carried: project };
      const original = await this.#pictures.read(own.file, own.name, signal);
      this.#pictures.drop(picture);
      return { picture: original, project, carried: null };
    } catch (error) {
      return { picture, project: null, carried: asError(error) };
    }
  }

  /**
   * The first file that is a picture. A drawing is kept as another file than its source.
   *
   * @throws C2WarpError about the first file if none is a picture.
   */
  async #firstPicture(
    files: readonly NamedFile[],
    signal: AbortSignal,
  ): Promise<{ readonly picture: Picture; readonly source: NamedFile['file'] }> {
    let refusal: unknown;
    for (const { file, name } of files) {
      signal.throwIfAborted();
      try {
        return { picture: await this.#pictures.read(file, name, signal), source: file };
      } catch (error) {
        refusal ??= error;
      }
    }
    throw refusal;
  }

  abandon(id: number): void {
    this.#reads.get(id)?.abort();
  }

  /** Asks for a file to open. */
  async pick(): Promise<void> {
    try {
      const file = await openFile();
      if (file) this.#dispatch({ type: 'files-received', files: [{ name: file.name, file }] });
    } catch (error) {
      this.#dispatch({ type: 'error-reported', error: asError(error) });
    }
  }

  /**
   * @param of the same project in the document, which then counts as saved.
   * @param picture to be held in the file.
   */
  async saveProject(name: string, project: Project, of: Project, picture: NamedFile | null): Promise<void> {
    try {
      const text = this.#text(project, picture).then(
        (text) => new Blob([text], { type: 'application/json' }),
      );
      if (await saveFile(text, name, 'project')) this.#dispatch({ type: 'project-saved', project: of });
    } catch (error) {
      this.#dispatch({ type: 'error-reported', error: asError(error) });
    }
  }

  /** Saves an SVG; nothing if it is null. */
  async saveFigure(name: string, figure: Promise<string | null>): Promise<void> {
    try {
      const text = await figure;
      if (text === null) return;
      const saved = await saveFile(new Blob([text], { type: 'image/svg+xml' }), name, 'svg');
      if (saved) this.#dispatch({ type: 'figure-saved', name: saved });
    } catch (error) {
      this.#dispatch({ type: 'error-reported', error: asError(error) });
    }
  }

  /** Saves the warped picture. A PNG carries the project. */
  exportPicture(order: ExportOrder, pixelated: boolean, following: ExportFollowing): Promise<string | null> {
    const { format } = order.choices;
    const file =
      format === 'svg'
        ? bentFile(order, this.#pictures, following)
        : this.#written(order, format, pixelated, following);
    return saveFile(file, order.name, format);
  }

  dispose(): void {
    for (const controller of this.#reads.values()) controller.abort();
  }

  async #text(project: Project, picture: NamedFile | null): Promise<string> {
    return projectText(picture ? await joinedProject(project, picture) : project);
  }

  async #written(
    { project, moment, choices, carried }: ExportOrder,
    format: PixelFormat,
    pixelated: boolean,
    following: ExportFollowing,
  ): Promise<Blob> {
    const { percent, area, quality, background } = choices;
    const chunks =
      format === 'png' ? [textChunk(KEYWORD, await this.#text(carried.project, carried.picture))] : [];
    const drawing = this.#solver.draw(project, { scale: percent / 100, area, pixelated }, moment);
    const { type } = EXPORT_FORMATS[format];
    const settings = { type, quality: quality / 100, background, chunks };
    return writtenFile(drawing, settings, following);
  }

  async #project(given: ProjectSource, options: FetchOptions): Promise<ReadProject> {
    if ('object' in given) return this.#parsed(JSON.stringify(given.object));
    const { name, file } = 'address' in given ? await fetched(given.address, options) : given.named;
    try {
      return await this.#parsed(new TextDecoder().decode(await readBytes(file as Blob)));
    } catch (error) {
      throw withFileName(name, error);
    }
  }

  async #parsed(text: string): Promise<ReadProject> {
    const split = splitProject(text);
    return { project: await this.#solver.readProject(split.text), picture: split.picture };
  }
}

/** A project, and the picture that its file holds. */
interface ReadProject {
  readonly project: Project;
  readonly picture: NamedFile | null;
}

const NO_PROJECT = { project: null, picture: null };

const fetched = async (address: string, options: FetchOptions): Promise<NamedFile> => ({
  name: fileName(address),
  file: await fetchFile(address, options),
});
