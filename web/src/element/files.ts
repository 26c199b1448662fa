/** Opening and saving: by picker, drop, paste and address; what goes wrong is said, and nothing open is lost by it. */
import type { Project } from '../document/project';
import { openFile, saveFile } from '../io/files';
import type { Notice } from '../ui/model';
import { fileName, fits, readPicture, sortFiles, stem } from './picture';
import type { Kept, Workbench } from './workbench';

export interface FilesHost {
  notify(notice: Notice): void;
  report(error: unknown): void;
  progressed(label: string | null): void;
}

export class Files {
  readonly #workbench: Workbench;
  readonly #host: FilesHost;
  /** A project that came without its picture. */
  #awaiting: { readonly name: string; readonly project: Project } | null = null;

  constructor(workbench: Workbench, host: FilesHost) {
    this.#workbench = workbench;
    this.#host = host;
  }

  /** Asks for a picture or a project. */
  async choose(): Promise<void> {
    await this.#guarded(async () => {
      const file = await openFile('any');
      if (file) await this.#receive([file]);
    });
  }

  /** Takes what was dropped, pasted or chosen; a project and its picture may come together. */
  async receive(files: readonly File[]): Promise<void> {
    await this.#guarded(() => this.#receive(files));
  }

  /** Opens from addresses or blobs. @throws Error, with what was open before still there. */
  async load(source: string | Blob, project?: string | Project): Promise<void> {
    const file = typeof source === 'string' ? await fetched(source) : source;
    const name =
      typeof source === 'string' ? fileName(source) : source instanceof File ? source.name : 'picture.png';
    const text = typeof project === 'string' ? await (await fetched(project)).text() : undefined;
    const given = text === undefined ? project : await this.#workbench.readProject(text);
    await this.#openPicture(file, name, typeof given === 'string' ? undefined : given);
  }

  async restore(kept: Kept): Promise<void> {
    await this.#workbench.open(await readPicture(kept.file, kept.name), kept.record);
  }

  async save(): Promise<void> {
    await this.#guarded(async () => {
      const { name, blob } = this.#workbench.projectFile();
      await saveFile(blob, name, 'project');
    });
  }

  async export(): Promise<void> {
    const { picture } = this.#workbench;
    if (!picture) return;
    await this.#guarded(async () => {
      this.#host.progressed('Exporting');
      await saveFile(this.#workbench.png(), `${stem(picture.name)}-warped.png`, 'png');
    });
    this.#host.progressed(null);
  }

  async #receive(files: readonly File[]): Promise<void> {
    const { picture, project } = sortFiles(files);
    const given = project && (await this.#readProject(project));
    if (picture) await this.#openOther(picture, given?.project);
    else if (given) this.#openProject(given.name, given.project);
  }

  async #readProject(file: File): Promise<{ name: string; project: Project }> {
    try {
      return { name: file.name, project: await this.#workbench.readProject(await file.text()) };
    } catch (error) {
      if (error instanceof Error) error.message = `${file.name}: ${error.message}`;
      throw error;
    }
  }

  /** A project alone goes with the picture that is open, if it is of that size. */
  #openProject(name: string, project: Project): void {
    const { picture } = this.#workbench;
    if (picture && fits(picture, project)) {
      this.#workbench.adopt(project, `Open ${name}`);
      return;
    }
    const { src, width, height } = project.image;
    this.#awaiting = { name, project };
    this.#host.notify({
      kind: 'info',
      text: `${name} belongs to the picture ${src || 'it was made for'} (${width} × ${height} px). Open that picture to go on.`,
      action: { label: 'Open picture', run: () => void this.choose() },
    });
  }

  /** Opens a picture over another, with a way back. */
  async #openOther(file: File, project?: Project): Promise<void> {
    const before = this.#workbench.kept;
    const edited = before !== null && before.record.past.length > 0;
    await this.#openPicture(file, file.name || 'pasted.png', project);
    if (!before || !edited) return;
    this.#host.notify({
      kind: 'info',
      text: `${file.name || 'The pasted picture'} is open.`,
      action: { label: `Back to ${before.name}`, run: () => void this.#guarded(() => this.restore(before)) },
    });
  }

  async #openPicture(file: Blob, name: string, given?: Project): Promise<void> {
    const picture = await readPicture(file, name);
    const awaited =
      this.#awaiting && fits(picture, this.#awaiting.project) ? this.#awaiting.project : undefined;
    const project = given ?? awaited;
    if (project && !fits(picture, project)) {
      const { width, height } = project.image;
      const message = `The project is for a picture of ${width} × ${height} px; ${name} has ${picture.width} × ${picture.height} px.`;
      throw Object.assign(new Error(message), { code: 'image-size' });
    }
    this.#awaiting = null;
    const present = project && { project, selection: [] };
    await this.#workbench.open(picture, present && { past: [], present, future: [] });
  }

  async #guarded(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.#host.report(error);
    }
  }
}

async function fetched(address: string): Promise<Blob> {
  const response = await fetch(address).catch((cause: unknown) => {
    throw new Error(
      `${fileName(address)} could not be loaded: is the address right, and the network there?`,
      { cause },
    );
  });
  if (!response.ok)
    throw new Error(`${fileName(address)} could not be loaded: the server answered ${response.status}.`);
  return response.blob();
}
