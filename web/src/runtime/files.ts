/** Reads what is opened, and saves what is exported. */

import type { Project } from '../document/project';
import { projectText } from '../document/project_text';
import type { ProjectSource } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import type { NamedFile, Picture } from '../editor/picture';
import { asError } from '../error';
import { fetchFile, fileName } from '../io/address';
import { encodePng } from '../io/encode';
import { openFile, saveFile } from '../io/files';
import { readBytes } from '../io/read';
import { type Pictures, withFileName } from './pictures';
import type { Solver } from './solver';

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

  /** Reads a picture, a project, or both. */
  async read(
    id: number,
    sources: readonly (string | NamedFile)[],
    given: ProjectSource | null,
  ): Promise<void> {
    const controller = new AbortController();
    this.#reads.set(id, controller);
    const { signal } = controller;
    try {
      const files = await Promise.all(
        sources.map((source) => (typeof source === 'string' ? fetched(source, signal) : source)),
      );
      const project = given && !signal.aborted ? await this.#project(given, signal) : null;
      if (signal.aborted) return;
      const picture = files.length > 0 ? await this.#firstPicture(files, signal) : null;
      if (picture && signal.aborted) this.#pictures.drop(picture);
      if (signal.aborted) return;
      this.#dispatch({ type: 'read-ended', id, picture, project });
    } catch (error) {
      if (!signal.aborted) this.#dispatch({ type: 'read-failed', id, error: asError(error) });
    } finally {
      this.#reads.delete(id);
    }
  }

  /** The first file that is a picture. @throws WarpError about the first file if none is. */
  async #firstPicture(files: readonly NamedFile[], signal: AbortSignal): Promise<Picture> {
    let refusal: unknown;
    for (const { file, name } of files) {
      signal.throwIfAborted();
      try {
        return await this.#pictures.read(file, name);
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

  async saveProject(name: string, project: Project): Promise<void> {
    try {
      await saveFile(new Blob([projectText(project)], { type: 'application/json' }), name, 'project');
    } catch (error) {
      this.#dispatch({ type: 'error-reported', error: asError(error) });
    }
  }

  /** Saves the warped picture as PNG. `cut`: the export cuts off a part of it. */
  async export(
    name: string,
    project: Project,
    grow: boolean,
    pixelated: boolean,
    cut: boolean,
  ): Promise<void> {
    try {
      const saved = await saveFile(this.#png(project, grow, pixelated), name, 'png');
      this.#dispatch({ type: 'export-ended', saved, cut, error: null });
    } catch (error) {
      this.#dispatch({ type: 'export-ended', saved: false, cut, error: asError(error) });
    }
  }

  dispose(): void {
    for (const controller of this.#reads.values()) controller.abort();
  }

  async #png(project: Project, grow: boolean, pixelated: boolean): Promise<Blob> {
    const { width, height, rgba } = await this.#solver.warp(project, 1, grow, pixelated);
    return encodePng(width, height, rgba);
  }

  async #project(given: ProjectSource, signal: AbortSignal): Promise<Project> {
    if ('object' in given) return this.#solver.readProject(JSON.stringify(given.object));
    if ('address' in given) {
      const file = await fetchFile(given.address, signal);
      return this.#solver.readProject(await file.text());
    }
    const { name, file } = given.named;
    try {
      const text = new TextDecoder().decode(await readBytes(file as Blob));
      return await this.#solver.readProject(text);
    } catch (error) {
      throw withFileName(name, error);
    }
  }
}

const fetched = async (address: string, signal: AbortSignal): Promise<NamedFile> => ({
  name: fileName(address),
  file: await fetchFile(address, signal),
});
