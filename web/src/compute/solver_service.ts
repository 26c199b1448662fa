/**
 * The solver's end of the connection: owns a session and answers requests one after another. The only file that wraps
 * the generated session: workers and programs without a worker both run it.
 *
 * Errors with a code are sent as replies. Anything else is a panic, after which the module's memory cannot be trusted:
 * the service reports that it died, and its owner starts another.
 */
import { asError, codeOf, ENGINE, handlesOf, wordingOf } from '../error';
import { say } from '../texts/wording';
import { engineError } from './engine_error';
import init, {
  __wbg_reset_state,
  Canvas,
  ClipPoses,
  type Drawing,
  type Filming,
  History,
  join_later,
  Session,
  type Solution,
} from './generated/c2warp';
import type {
  Boot,
  DrawingSize,
  Extension,
  Failure,
  FilmSize,
  Messages,
  Moment,
  Reply,
  Request,
  SiteMotions,
} from './messages';
import { nextTask, Queue } from './queue';
import type { Report, SolutionData, Stage } from './solution';
import { WARM_UP } from './warm_up';

const CANVASES = { picture: Canvas.Picture, grown: Canvas.Grown, covered: Canvas.Covered } as const;

const lostDrawing = (): Failure => {
  const { code, message, wording } = engineError(ENGINE, say('errors.engine.lostDrawing'));
  return { code, message, wording };
};

/** Set by a panic: the next service needs a new instance of the module. */
let broken = false;

/** Sends a reply to the owner of the service. */
export type Post = (reply: Reply, transfer?: Transferable[]) => void;

export interface ServiceOptions {
  /** Solves a small scene first, so that the first real solve is fast. */
  readonly warmUp: boolean;
}

export class SolverService {
  readonly #post: Post;
  readonly #options: ServiceOptions;
  #session: Session | undefined;
  /** Its parts of the module must not be freed. */
  #died = false;
  /** The drawings of the present picture, by the ids of their requests. */
  readonly #drawings = new Map<number, Drawing>();
  /** The films of the present picture, by the ids of their requests. */
  readonly #films = new Map<number, Filming>();
  readonly #queue = new Queue<Boot | Extension | Request>((message) => this.#receive(message));

  constructor(post: Post, options: ServiceOptions) {
    this.#post = post;
    this.#options = options;
  }

  push(message: Boot | Extension | Request): void {
    this.#queue.push(message);
  }

  /** Frees the memory of the module. Requests that wait are not answered. */
  dispose(): void {
    this.#queue.clear();
    if (this.#died) return;
    this.#releasePicture();
    this.#session?.free();
    this.#session = undefined;
  }

  async #receive(message: Boot | Extension | Request): Promise<void> {
    try {
      if ('module' in message) await this.#boot(message.module);
      else if ('later' in message) join_later(message.later);
      else await this.#answer(message);
    } catch (error) {
      // Exhausted stacks and memory are other errors than panics.
      broken ||= error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
      this.#died = true;
      this.#post({ kind: 'died', started: this.#session !== undefined, message: String(error) });
    }
  }

  async #boot(module: WebAssembly.Module): Promise<void> {
    await init({ module_or_path: module });
    if (broken) {
      broken = false;
      __wbg_reset_state();
    }
    this.#session = new Session();
    // Skipped where a request is waiting already.
    if (this.#options.warmUp && !this.#queue.waits(() => true)) warmUp();
  }

  async #answer(request: Request): Promise<void> {
    if (!this.#session) throw new Error('the request arrived before the module');
    try {
      await this.#handle(this.#session, request);
    } catch (error) {
      const failure = asFailure(error);
      if (!failure) throw error;
      this.#post({ id: request.id, kind: 'failed', failure });
    }
  }

  async #handle(session: Session, request: Request): Promise<void> {
    const { id } = request;
    const done = (body: Messages[keyof Messages][1], transfer: Transferable[] = []) =>
      this.#post({ id, kind: 'done', body }, transfer);
    const lost = () => this.#post({ id, kind: 'failed', failure: lostDrawing() });
    switch (request.name) {
      case 'picture': {
        const { width, height, pixels } = request.body;
        session.set_picture(width, height, await received(pixels));
        this.#releasePicture();
        return done(null);
      }
      case 'fit': {
        const { project, own } = request.body;
        const rgba = own ? await received(own.pixels) : undefined;
        return done(session.fit(project, rgba));
      }
      case 'suggest':
        return done(session.suggest(request.body.project));
      case 'solve': {
        if (!(await this.#advanced(session, request.body.project, id))) {
          return this.#post({ id, kind: 'superseded' });
        }
        const solution = copiedOut(session.solution());
        return done(solution, buffers(solution));
      }
      case 'fill': {
        if (!(await this.#filled(session, request))) return;
        const fill = session.fill();
        if (!fill) return done(null);
        const { box, rgba } = fill;
        fill.free();
        const [left = 0, top = 0, width = 0, height = 0] = box;
        return done({ box: [left, top, width, height], rgba }, [rgba.buffer]);
      }
      case 'stop':
        // Its arrival has stopped a solve.
        return done(null);
      case 'draw': {
        const { project, history, scale, area, pixelated } = request.body;
        const drawn = session.draw(project, scale, CANVASES[area], pixelated, historyOf(history));
        return done(this.#begun(id, drawn));
      }
      case 'film': {
        const { project, clip, rate, range, scale, pixelated } = request.body;
        const [from, to] = range ?? [];
        const film = session.film(project, clip, rate, from, to, scale, pixelated);
        this.#films.set(id, film);
        return done(sizeOf(id, film));
      }
      case 'include': {
        const film = this.#films.get(request.body.film);
        if (!film) return lost();
        session.include(film, request.body.frame);
        return done(sizeOf(request.body.film, film));
      }
      case 'at-rest':
      case 'frame': {
        const film = this.#films.get(request.body.film);
        if (!film) return lost();
        const drawn =
          request.name === 'frame' ? session.frame(film, request.body.frame) : session.picture_at_rest(film);
        return done(this.#begun(id, drawn));
      }
      case 'release-film':
        this.#films.get(request.body.film)?.free();
        this.#films.delete(request.body.film);
        return done(null);
      case 'rows': {
        const { drawing, from, to } = request.body;
        const drawn = this.#drawings.get(drawing);
        // The picture was replaced, or this service replaces the one that began the drawing.
        if (!drawn) return lost();
        const rgba = session.rows(drawn, from, to);
        return done(rgba, [rgba.buffer]);
      }
      case 'release':
        this.#drawings.get(request.body.drawing)?.free();
        this.#drawings.delete(request.body.drawing);
        return done(null);
      case 'map': {
        const { project, history, points } = request.body;
        const mapped = session.map(project, points, historyOf(history)) as Float64Array<ArrayBuffer>;
        return done(mapped, [mapped.buffer]);
      }
      case 'inverse': {
        const { project, history, points } = request.body;
        const rest = session.inverse(project, points, historyOf(history)) as Float64Array<ArrayBuffer>;
        return done(rest, [rest.buffer]);
      }
      case 'posed-mesh': {
        const { project, history } = request.body;
        const mesh = session.posed_mesh(project, historyOf(history));
        const { positions, triangles, folds } = mesh;
        mesh.free();
        return done({ positions, triangles, folds }, [positions.buffer, triangles.buffer, folds.buffer]);
      }
      case 'next-pose': {
        const { project, history, next, settles } = request.body;
        const motions = session.next_pose(project, historyOf(history), next, settles);
        return done(motions as SiteMotions['motions'], [motions.buffer]);
      }
      case 'clip-poses': {
        const { handles, moment } = request.body;
        const clip = new ClipPoses(moment.clip, handles);
        const poses = clip.at(moment.time);
        clip.free();
        return done(poses as Float64Array<ArrayBuffer>, [poses.buffer]);
      }
      case 'weights': {
        const rows = session.weights(request.body.project, request.body.points);
        const { offsets, sites, weights } = rows;
        rows.free();
        return done({ offsets, sites, weights }, [offsets.buffer, sites.buffer, weights.buffer]);
      }
      case 'distances': {
        const { project, from, points } = request.body;
        const distances = session.distances(project, ...from, points) as Float64Array<ArrayBuffer>;
        return done(distances, [distances.buffer]);
      }
      case 'path': {
        const { project, from, to } = request.body;
        const path = session.path(project, ...from, ...to) as Float64Array<ArrayBuffer>;
        return done(path, [path.buffer]);
      }
      case 'cells': {
        const borders = session.cell_borders(request.body.project);
        const { corners, barycentric } = borders;
        borders.free();
        return done({ corners, barycentric }, [corners.buffer, barycentric.buffer]);
      }
      case 'study':
        return done(JSON.parse(session.study(request.body.project)));
      case 'lens': {
        const { project, at } = request.body;
        const lens = session.lens(project, ...at);
        return done(lens === undefined ? null : JSON.parse(lens));
      }
    }
  }

  /** Runs the stages; false where a newer request has made the remaining ones pointless. */
  async #advanced(session: Session, project: string, id: number): Promise<boolean> {
    const overtaken = () =>
      this.#queue.waits((waiting) => 'name' in waiting && ENDS_SOLVES.includes(waiting.name));
    if (overtaken()) return false;
    session.begin(project);
    for (let stage = session.advance(); stage !== undefined; stage = session.advance()) {
      this.#post({ id, kind: 'progress', stage: stage as Stage });
      await nextTask();
      if (overtaken()) return false;
    }
    return true;
  }

  /** Runs the steps of a fill; false where a newer request ends it, or a solve comes first. */
  async #filled(session: Session, request: Extract<Request, { name: 'fill' }>): Promise<boolean> {
    const { id } = request;
    const waits = (names: readonly string[]) =>
      this.#queue.waits((waiting) => 'name' in waiting && names.includes(waiting.name));
    session.begin_fill(request.body.project);
    for (let part = session.advance_fill(); part !== undefined; part = session.advance_fill()) {
      this.#post({ id, kind: 'progress', stage: part });
      await nextTask();
      if (waits(ENDS_FILLS)) {
        this.#post({ id, kind: 'superseded' });
        return false;
      }
      if (waits(['solve'])) {
        // The fill continues after it.
        this.#queue.push(request);
        return false;
      }
    }
    return true;
  }

  /** Keeps a drawing by the id of its request. */
  #begun(drawing: number, drawn: Drawing): DrawingSize {
    this.#drawings.set(drawing, drawn);
    const { width, height, bandRows } = drawn;
    const [x = 0, y = 0] = drawn.origin;
    return { drawing, width, height, origin: [x, y], bandRows };
  }

  #releasePicture(): void {
    for (const drawn of [...this.#drawings.values(), ...this.#films.values()]) drawn.free();
    this.#drawings.clear();
    this.#films.clear();
  }
}

/** Requests that end a running fill. */
const ENDS_FILLS: readonly string[] = ['fill', 'picture', 'stop'] satisfies readonly (keyof Messages)[];

/** Requests that end a running solve. */
const ENDS_SOLVES: readonly string[] = ['solve', 'picture', 'stop'] satisfies readonly (keyof Messages)[];

/** The module takes it over. */
function historyOf(history: Moment | SiteMotions | null): History | undefined {
  if (!history) return undefined;
  return 'motions' in history
    ? History.of_motions(history.motions)
    : History.of_clip(history.clip, history.time);
}

const sizeOf = (film: number, { width, height, frames, endlessly }: Filming): FilmSize => ({
  film,
  width,
  height,
  frames,
  endlessly,
});

/** The pixels that arrive at a port. @throws C2WarpError with the code `picture` if the picture was released. */
function received(port: MessagePort): Promise<Uint8Array> {
  return new Promise((resolve, reject) => {
    port.onmessage = ({ data }: MessageEvent<Uint8Array | null>) => {
      port.close();
      if (data) resolve(data);
      else reject(engineError('picture', say('errors.engine.released')));
    };
  });
}

/** The data of a solution, which is freed. */
export function copiedOut(solution: Solution): SolutionData {
  const data: SolutionData = {
    positions: solution.positions,
    triangles: solution.triangles,
    backgroundPositions: solution.background_positions,
    backgroundTriangles: solution.background_triangles,
    featherPositions: solution.feather_positions,
    featherOwners: solution.feather_owners,
    featherLevels: solution.feather_levels,
    featherTriangles: solution.feather_triangles,
    offsets: solution.offsets,
    sites: solution.sites,
    weights: solution.weights,
    siteRest: solution.site_rest,
    siteHandle: solution.site_handle,
    siteEdges: solution.site_edges,
    poser: solution.poser,
    report: JSON.parse(solution.report) as Report,
  };
  solution.free();
  return data;
}

function buffers({ report: _, ...arrays }: SolutionData): ArrayBuffer[] {
  return Object.values(arrays).map(({ buffer }) => buffer);
}

function asFailure(error: unknown): Failure | undefined {
  const code = codeOf(error);
  return code
    ? { code, message: asError(error).message, handles: handlesOf(error), wording: wordingOf(error) }
    : undefined;
}

function warmUp(): void {
  const scratch = new Session();
  scratch.set_picture(WARM_UP.size, WARM_UP.size, WARM_UP.pixels());
  scratch.begin(WARM_UP.project);
  while (scratch.advance() !== undefined);
  scratch.free();
}
