/** Opening and saving: by picker, drop, paste and address; what goes wrong is said, and nothing open is lost by it. */
import type { Project, ProjectFile } from '../document/project';
import { fetchFile, fileName } from '../io/address';
import { openFile, saveFile } from '../io/files';
import { readBytes } from '../io/read';
import type { Notice } from '../ui/model';
import { fits, misfit, ofFile, type Picture, readPicture, sortFiles, stem } from './picture';
import { type Turn, Turns } from './turn';
import type { Kept, Work, Workbench } from './workbench';

/** What a person has brought, and that is not in hand now. It is still there where the element has moved. */
export interface Aside {
  /** A project that came without its picture. */
  awaiting: { readonly name: string; readonly project: Project } | null;
  /** Pictures that a person has worked on and left for others, the last one last. */
  left: readonly Kept[];
}

export interface FilesHost {
  changed(): void;
  /** Something is open, whoever brought it. */
  opened(): void;
  notify(notice: Notice): void;
  report(error: unknown): void;
  /** Something has begun that takes a while. Returns what ends it. */
  begin(label: string): () => void;
  /** What a person has brought is open, but for these: of several pictures the first is opened. */
  received(ignored: readonly string[]): void;
  /** Whether an export leaves out something of the picture as it is bent now. */
  cuts(): boolean;
}

/** The size is the picture's by contract: what is bent beyond it has no place there. */
const CUT =
  'What reaches beyond the frame of the picture is cut off in the PNG, which has the size of the original.';

const isWorkedOn = ({ record, drawings }: Work): boolean =>
  record.past.length > 0 || Object.values(drawings ?? {}).some(({ draft }) => draft !== undefined);

export class Files {
  readonly #workbench: Workbench;
  readonly #host: FilesHost;
  readonly #aside: Aside;
  readonly #turns = new Turns();
  /** How many are being opened: one may have been overtaken and not know it yet. */
  #opening = 0;

  constructor(workbench: Workbench, aside: Aside, host: FilesHost) {
    this.#workbench = workbench;
    this.#aside = aside;
    this.#host = host;
  }

  /** Something is being opened. */
  get opening(): boolean {
    return this.#opening > 0;
  }

  /** Asks for a picture or a project. */
  async choose(): Promise<void> {
    await this.#guarded(async () => {
      const file = await openFile('any');
      if (file) await this.shown(() => this.#take([file]));
    });
  }

  /** Takes what was dropped, pasted or chosen; a project and its picture may come together. */
  async receive(files: readonly File[]): Promise<void> {
    await this.#guarded(() => this.shown(() => this.#take(files)));
  }

  /** Opens something, and shows that it does for as long as it takes. */
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

  /** The turn to open something: what is being opened in the turn before is given up. */
  turn(): Turn {
    return this.#turns.take();
  }

  /**
   * Opens from addresses or blobs, a project also from what a page made.
   * @throws Error, with what was open before still there. DOMException `AbortError` once the turn is over.
   */
  async load(source: string | Blob, project?: string | ProjectFile, turn = this.turn()): Promise<void> {
    // At once: a page may go on changing what it gave.
    const made = typeof project === 'object' ? JSON.stringify(project) : undefined;
    turn.check();
    const file = typeof source === 'string' ? await turn.through(fetchFile(source, turn.signal)) : source;
    const name =
      typeof source === 'string' ? fileName(source) : source instanceof File ? source.name : 'picture.png';
    const text = typeof project === 'string' ? await this.#fetchedText(project, turn) : made;
    const given = text === undefined ? undefined : await turn.through(this.#workbench.readProject(text));
    const { picture, work } = await this.#ready(file, name, turn, given);
    await this.#open(picture, work);
  }

  async restore(kept: Kept, turn = this.turn()): Promise<void> {
    await this.#open(await this.#picture(kept.file, kept.name, turn), kept);
  }

  /** Gives up what is being opened, and opens nothing more. */
  dispose(): void {
    this.#turns.close();
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
    const end = this.#host.begin('Exporting');
    await this.#guarded(async () => {
      const cut = this.#host.cuts();
      await saveFile(this.#workbench.png(), `${stem(picture.name)}-warped.png`, 'png');
      if (cut) this.#host.notify({ kind: 'info', text: CUT });
    });
    end();
  }

  async #receive(files: readonly File[]): Promise<void> {
    const { picture, project } = sortFiles(files);
    // A project alone opens nothing: it is for the picture that is open.
    const turn = picture && this.turn();
    const given = project && (await this.#readProject(project));
    if (picture && turn) {
      const ready = await this.#ready(picture, picture.name || 'pasted.png', turn, given?.project);
      await this.#openOther(ready.picture, ready.work);
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

  /** A project alone goes with the picture that is open, if it is of that size. */
  #openProject(name: string, project: Project): void {
    const { picture } = this.#workbench;
    if (picture && fits(picture, project)) {
      this.#workbench.adopt(project, `Open ${name}`);
      return;
    }
    this.#aside.awaiting = { name, project };
    this.#ask();
  }

  /** For the picture of the project that waits. */
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

  /** Opens a picture over another, with a way back to that if it was worked on. @param left those that others lead back to. */
  async #openOther(picture: Picture, work?: Work, left = this.#aside.left): Promise<void> {
    const { kept } = this.#workbench;
    await this.#open(picture, work, kept && isWorkedOn(kept) ? [...left, kept] : left);
  }

  /** What a person has left, or else what waits, is offered whatever comes of it: another picture, or the one before it again. */
  async #open(picture: Picture, work?: Work, left = this.#aside.left): Promise<void> {
    try {
      await this.#workbench.open(picture, work);
      this.#aside.left = left;
      this.#host.opened();
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
    const picture = await this.#picture(kept.file, kept.name, this.turn());
    const others = this.#aside.left.filter((other) => other !== kept);
    await this.#openOther(picture, kept, others);
  }

  /** A picture to be opened, with the project that was given for it or waits for it. */
  async #ready(
    file: Blob,
    name: string,
    turn: Turn,
    given?: Project,
  ): Promise<{ picture: Picture; work?: Work }> {
    const picture = await this.#picture(file, name, turn);
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

  async #picture(file: Blob, name: string, turn: Turn): Promise<Picture> {
    turn.check();
    const reading = readPicture(file, name);
    try {
      return await turn.through(reading);
    } catch (error) {
      reading.then(
        ({ bitmap }) => bitmap.close(),
        () => {},
      );
      throw error;
    }
  }

  async #fetchedText(address: string, turn: Turn): Promise<string> {
    const file = await turn.through(fetchFile(address, turn.signal));
    return turn.through(file.text());
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
