/** Opens and saves files: picker, drop, paste and address. Errors are reported and never cost the open work. */
import type { Pixels } from '../compute/solution';
import type { Project, ProjectFile } from '../document/project';
import { fetchFile, fileName } from '../io/address';
import { encodePng } from '../io/encode';
import { openFile, saveFile } from '../io/files';
import { readBytes } from '../io/read';
import type { Notice } from '../ui/model';
import { isAbort, LatestRequest, unlessAborted } from './latest';
import { fits, misfit, ofFile, type Picture, readPicture, sortFiles, stem } from './picture';
import { isWorkedOn, type Kept, type Work, type Workbench } from './workbench';

/** Projects and pictures of a person that are not open now. Kept when the element is moved. */
export interface Aside {
  /** A project that was opened without its picture. */
  awaiting: { readonly name: string; readonly project: Project } | null;
  /** Edited pictures that were replaced by others, oldest first. */
  left: readonly Kept[];
}

export interface FilesHost {
  changed(): void;
  /** A picture is open, whether the page or a person opened it; `given`, with a project of its own. */
  opened(given: boolean): void;
  notify(notice: Notice): void;
  report(error: unknown): void;
  /** Shows a long operation. Returns a function that ends the display. */
  begin(label: string): () => void;
  /**
   * A person's files have been taken, except those ignored: only the first picture and the first project are opened.
   */
  received(ignored: readonly string[]): void;
  /** Whether an export would cut off part of the posed picture. */
  cuts(): boolean;
  /** The warped picture, of the size of the original, or grown to hold all of it. */
  warped(grow: boolean): Promise<Pixels>;
}

const CUT =
  'What reaches beyond the frame of the picture is cut off in the PNG, which has the size of the original.';

export class Files {
  readonly #workbench: Workbench;
  readonly #host: FilesHost;
  readonly #aside: Aside;
  readonly #requests = new LatestRequest();
  readonly #returns = new LatestRequest();
  /** Work that is being brought back, until it or something else is open. */
  #returning: Kept | null = null;
  /** A count, since an overtaken opening ends only after the next has begun. */
  #opening = 0;

  constructor(workbench: Workbench, aside: Aside, host: FilesHost) {
    this.#workbench = workbench;
    this.#aside = aside;
    this.#host = host;
  }

  /** Whether something is being opened. */
  get opening(): boolean {
    return this.#opening > 0;
  }

  /** Opens a picture or project from the file picker. */
  async choose(): Promise<void> {
    await this.#guarded(async () => {
      const file = await openFile();
      if (file) await this.shown(() => this.#take([file]));
    });
  }

  /** Opens dropped or pasted files; a project and its picture may come together. */
  async receive(files: readonly File[]): Promise<void> {
    await this.#guarded(() => this.shown(() => this.#take(files)));
  }

  /** Shows that something is being opened while `work` runs. */
  async shown<T>(work: () => Promise<T>): Promise<T> {
    this.#opening += 1;
    this.#host.changed();
    try {
      return await work();
    } finally {
      this.#opening -= 1;
      this.#host.changed();
    }
  }

  /** Aborts what is being opened. Returns the signal for what is opened next. */
  overtake(): AbortSignal {
    return this.#requests.next();
  }

  /**
   * Opens a picture from an address or blob, with a project from an address or an object.
   * @throws Error if it cannot be opened; the previous picture stays. DOMException `AbortError` once aborted.
   */
  async load(source: string | Blob, project?: string | ProjectFile, signal = this.overtake()): Promise<void> {
    // Copied before the first await: the page may change its object later.
    const made = typeof project === 'object' ? JSON.stringify(project) : undefined;
    signal.throwIfAborted();
    const file = typeof source === 'string' ? await unlessAborted(signal, fetchFile(source, signal)) : source;
    const name =
      typeof source === 'string' ? fileName(source) : source instanceof File ? source.name : 'picture.png';
    const text = typeof project === 'string' ? await this.#fetchedText(project, signal) : made;
    const given =
      text === undefined ? undefined : await unlessAborted(signal, this.#workbench.readProject(text));
    const { picture, work } = await this.#ready(file, name, signal, given);
    await this.#open(picture, work, given !== undefined);
  }

  /**
   * Brings work back. Something else that is opened meanwhile ends that only once it can be opened: nothing is lost to
   * what cannot.
   * @throws Error if it cannot be opened; DOMException `AbortError` once something else is open.
   */
  async restore(kept: Kept): Promise<void> {
    const signal = this.#returns.next();
    this.#returning = kept;
    try {
      const picture = await this.#picture(kept.file, kept.name, signal);
      await this.#put(picture, kept, false);
    } finally {
      if (!signal.aborted) this.#returning = null;
    }
  }

  /** Edited pictures that were replaced by others, oldest first: the way back leads to the last one. */
  get left(): readonly Kept[] {
    return this.#aside.left;
  }

  set left(left: readonly Kept[]) {
    this.#aside.left = left;
  }

  /** Aborts what is being opened, and everything later. */
  dispose(): void {
    this.#requests.close();
    this.#returns.close();
  }

  async save(): Promise<void> {
    if (!this.#workbench.picture) return;
    await this.#guarded(async () => {
      const { name, blob } = this.#workbench.projectFile();
      await saveFile(blob, name, 'project');
    });
  }

  /**
   * Saves the warped picture as PNG, of the size of the original. Where that cuts something off, offers a PNG that is
   * grown to hold all of it.
   */
  async export(grow = false): Promise<void> {
    const { picture } = this.#workbench;
    if (!picture) return;
    const end = this.#host.begin('Exporting');
    await this.#guarded(async () => {
      const cut = !grow && this.#host.cuts();
      const name = `${stem(picture.name)}-warped${grow ? '-all' : ''}.png`;
      const saved = await saveFile(this.#png(grow), name, 'png');
      if (!saved || !cut) return;
      const action = { label: 'Export all', reads: true, run: () => void this.export(true) } as const;
      this.#host.notify({ kind: 'info', text: CUT, action, passes: true });
    });
    end();
  }

  async #png(grow: boolean): Promise<Blob> {
    const { width, height, rgba } = await this.#host.warped(grow);
    return encodePng(width, height, rgba);
  }

  async #receive(files: readonly File[]): Promise<void> {
    const { picture, project } = sortFiles(files);
    // A project alone does not overtake a picture that is being opened.
    const signal = picture && this.overtake();
    const given = project && (await this.#readProject(project));
    if (picture && signal) {
      const ready = await this.#ready(picture, picture.name || 'pasted.png', signal, given?.project);
      await this.#openOther(ready.picture, ready.work, given !== undefined);
    } else if (given) this.#openProject(given.name, given.project);
  }

  async #readProject(file: File): Promise<{ name: string; project: Project }> {
    try {
      const text = new TextDecoder().decode(await readBytes(file));
      return { name: file.name, project: await this.#workbench.readProject(text) };
    } catch (error) {
      throw ofFile(file.name, error);
    }
  }

  /** Applies a project to the open picture if the size fits; otherwise asks for its picture. */
  #openProject(name: string, project: Project): void {
    const { picture } = this.#workbench;
    if (picture && fits(picture, project)) {
      this.#workbench.adopt(project, `Open ${name}`);
      return;
    }
    this.#aside.awaiting = { name, project };
    this.#ask();
  }

  /** Asks for the picture of the waiting project. */
  #ask(): void {
    if (!this.#aside.awaiting) return;
    const { name, project } = this.#aside.awaiting;
    const { src, width, height } = project.image;
    this.#host.notify({
      kind: 'info',
      text: `${name} belongs to the picture ${src || 'it was made for'} (${width} × ${height} px). Open that picture to go on.`,
      action: { label: 'Open picture', run: () => void this.choose() },
    });
  }

  /**
   * Opens a person's picture, and offers a way back to the previous one if it was edited.
   * @param left the edited pictures before that.
   */
  async #openOther(picture: Picture, work?: Work, given = false, left = this.#aside.left): Promise<void> {
    const kept = this.#returning ?? this.#workbench.kept;
    await this.#open(picture, work, given, kept && isWorkedOn(kept) ? [...left, kept] : left);
  }

  /** Opens a picture in place of any work that is being brought back, which goes on where the picture is refused. */
  async #open(picture: Picture, work?: Work, given = false, left = this.#aside.left): Promise<void> {
    const returning = this.#returning;
    if (returning) this.#returns.next();
    try {
      await this.#put(picture, work, given, left);
      this.#returning = null;
    } catch (error) {
      if (returning && returning === this.#returning && !isAbort(error))
        await this.restore(returning).catch(() => {
          this.left = [...this.left, returning];
        });
      throw error;
    }
  }

  /**
   * Opens a picture. Then, also after an error, offers the way back, or else asks for the waiting project's picture.
   */
  async #put(
    picture: Picture,
    work: Work | undefined,
    given: boolean,
    left = this.#aside.left,
  ): Promise<void> {
    try {
      await this.#workbench.open(picture, work);
      this.#aside.left = left;
      this.#host.opened(given);
    } finally {
      if (this.#aside.left.length > 0) this.#offerBack();
      else this.#ask();
    }
  }

  #offerBack(): void {
    const { picture } = this.#workbench;
    const last = this.#aside.left.at(-1);
    if (!picture || !last) return;
    this.#host.notify({
      kind: 'info',
      text: `${picture.name} is open.`,
      action: { label: `Back to ${last.name}`, run: () => void this.#guarded(() => this.#back(last)) },
    });
  }

  async #back(kept: Kept): Promise<void> {
    const picture = await this.#picture(kept.file, kept.name, this.overtake());
    const others = this.#aside.left.filter((other) => other !== kept);
    await this.#openOther(picture, kept, false, others);
    this.#host.received([]);
  }

  /** Decodes a picture, and pairs it with the given project or a waiting one of its size. */
  async #ready(
    file: Blob,
    name: string,
    signal: AbortSignal,
    given?: Project,
  ): Promise<{ picture: Picture; work?: Work }> {
    const picture = await this.#picture(file, name, signal);
    const awaited = this.#aside.awaiting?.project;
    const project = given ?? (awaited && fits(picture, awaited) ? awaited : undefined);
    const error = project && misfit(picture, project);
    if (error) {
      picture.bitmap.close();
      throw error;
    }
    if (project === awaited) this.#aside.awaiting = null;
    const present = project && { project, selection: [] };
    return present ? { picture, work: { record: { past: [], present, future: [] } } } : { picture };
  }

  async #picture(file: Blob, name: string, signal: AbortSignal): Promise<Picture> {
    signal.throwIfAborted();
    const reading = readPicture(file, name);
    try {
      return await unlessAborted(signal, reading);
    } catch (error) {
      reading.then(
        ({ bitmap }) => bitmap.close(),
        () => {},
      );
      throw error;
    }
  }

  async #fetchedText(address: string, signal: AbortSignal): Promise<string> {
    const file = await unlessAborted(signal, fetchFile(address, signal));
    return unlessAborted(signal, file.text());
  }

  async #take(files: readonly File[]): Promise<void> {
    await this.#receive(files);
    const opened = Object.values<File>(sortFiles(files));
    this.#host.received(files.filter((file) => !opened.includes(file)).map(({ name }) => name));
  }

  async #guarded(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.#host.report(error);
    }
  }
}
