/**
 * The solving worker: owns the session. The only worker file that imports the generated code.
 *
 * Errors with a code are sent as replies. Anything else is a panic, after which the module's memory cannot be trusted:
 * the worker reports that it died, and the page replaces it.
 */
import init, { Canvas, type Drawing, type Filming, Session, type Solution } from '../generated/c2warp';
import {
  type Boot,
  type DrawingSize,
  type Failure,
  type FilmSize,
  type Messages,
  type Reply,
  type Request,
  SUPERSEDED,
} from '../messages';
import type { Report, SolutionData, Stage } from '../solution';
import { nextTask, Queue } from './queue';
import { WARM_UP } from './warm_up';

declare const self: DedicatedWorkerGlobalScope;

const RELEASED =
  'The pixels of the picture are gone, or there is no memory for them. Open the picture again.';

let session: Session | undefined;

/** The drawings of the present picture, by the ids of their requests. */
const drawings = new Map<number, Drawing>();

/** The films of the present picture, by the ids of their requests. */
const films = new Map<number, Filming>();

const CANVASES = { picture: Canvas.Picture, grown: Canvas.Grown, covered: Canvas.Covered } as const;

const LOST = 'The solver failed during the drawing.';

const queue = new Queue<Boot | Request>(async (message) => {
  try {
    if ('module' in message) await boot(message.module);
    else await answer(message);
  } catch (error) {
    post({ kind: 'died', started: session !== undefined, message: String(error) });
  }
});

self.onmessage = ({ data }: MessageEvent<Boot | Request>) => queue.push(data);

async function boot(module: WebAssembly.Module): Promise<void> {
  await init({ module_or_path: module });
  session = new Session();
  warmUp();
}

async function answer(request: Request): Promise<void> {
  if (!session) throw new Error('a request came before the module');
  try {
    await handle(session, request);
  } catch (error) {
    const failure = asFailure(error);
    if (!failure) throw error;
    post({ id: request.id, kind: 'failed', failure });
  }
}

async function handle(session: Session, request: Request): Promise<void> {
  const { id } = request;
  const done = (body: Messages[keyof Messages][1], transfer: Transferable[] = []) =>
    post({ id, kind: 'done', body }, transfer);
  switch (request.name) {
    case 'picture': {
      const { width, height, pixels } = request.body;
      session.set_picture(width, height, await received(pixels));
      for (const drawn of [...drawings.values(), ...films.values()]) drawn.free();
      drawings.clear();
      films.clear();
      return done(null);
    }
    case 'fit': {
      const { project, own } = request.body;
      const rgba = own ? await received(own.pixels) : undefined;
      return done(session.fit(project, rgba));
    }
    case 'solve': {
      if (!(await advanced(session, request.body.project, id))) {
        return post({ id, kind: 'failed', failure: { code: SUPERSEDED, message: 'superseded' } });
      }
      const solution = copiedOut(session.solution());
      return done(solution, buffers(solution));
    }
    case 'draw': {
      const { project, moment, scale, area, pixelated } = request.body;
      const drawn = session.draw(project, scale, CANVASES[area], pixelated, moment?.clip, moment?.time);
      return done(begun(id, drawn));
    }
    case 'film': {
      const { project, clip, rate, range, scale, pixelated } = request.body;
      const [from, to] = range ?? [];
      const film = session.film(project, clip, rate, from, to, scale, pixelated);
      films.set(id, film);
      return done(sizeOf(id, film));
    }
    case 'include': {
      const film = films.get(request.body.film);
      if (!film) return post({ id, kind: 'failed', failure: { code: 'engine', message: LOST } });
      session.include(film, request.body.frame);
      return done(sizeOf(request.body.film, film));
    }
    case 'at-rest':
    case 'frame': {
      const film = films.get(request.body.film);
      if (!film) return post({ id, kind: 'failed', failure: { code: 'engine', message: LOST } });
      const drawn =
        request.name === 'frame' ? session.frame(film, request.body.frame) : session.picture_at_rest(film);
      return done(begun(id, drawn));
    }
    case 'release-film':
      films.get(request.body.film)?.free();
      films.delete(request.body.film);
      return done(null);
    case 'rows': {
      const { drawing, from, to } = request.body;
      const drawn = drawings.get(drawing);
      // The picture was replaced, or this worker replaces the one that began the drawing.
      if (!drawn) return post({ id, kind: 'failed', failure: { code: 'engine', message: LOST } });
      const rgba = session.rows(drawn, from, to);
      return done(rgba, [rgba.buffer]);
    }
    case 'release':
      drawings.get(request.body.drawing)?.free();
      drawings.delete(request.body.drawing);
      return done(null);
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

const sizeOf = (film: number, { width, height, frames, endlessly }: Filming): FilmSize => ({
  film,
  width,
  height,
  frames,
  endlessly,
});

/** Keeps a drawing by the id of its request. */
function begun(drawing: number, drawn: Drawing): DrawingSize {
  drawings.set(drawing, drawn);
  const { width, height, bandRows } = drawn;
  return { drawing, width, height, bandRows };
}

/** The pixels that arrive at a port. @throws Error with the code `picture` if the picture was released. */
function received(port: MessagePort): Promise<Uint8Array> {
  return new Promise((resolve, reject) => {
    port.onmessage = ({ data }: MessageEvent<Uint8Array | null>) => {
      port.close();
      if (data) resolve(data);
      else reject(Object.assign(new Error(RELEASED), { code: 'picture' }));
    };
  });
}

/** Runs the stages; false where a newer request has made the remaining ones pointless. */
async function advanced(session: Session, project: string, id: number): Promise<boolean> {
  const overtaken = () =>
    queue.waits((waiting) => 'name' in waiting && (waiting.name === 'solve' || waiting.name === 'picture'));
  if (overtaken()) return false;
  session.begin(project);
  for (let stage = session.advance(); stage !== undefined; stage = session.advance()) {
    post({ id, kind: 'progress', stage: stage as Stage });
    await nextTask();
    if (overtaken()) return false;
  }
  return true;
}

function copiedOut(solution: Solution): SolutionData {
  const data: SolutionData = {
    positions: solution.positions,
    triangles: solution.triangles,
    backgroundPositions: solution.background_positions,
    backgroundTriangles: solution.background_triangles,
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
  if (!(error instanceof Error) || !('code' in error) || typeof error.code !== 'string') return undefined;
  const { handles } = error as Partial<Failure>;
  return { code: error.code, message: error.message, ...(handles && { handles }) };
}

/** Skipped where a request is waiting already. */
function warmUp(): void {
  if (queue.waits(() => true)) return;
  const scratch = new Session();
  scratch.set_picture(WARM_UP.size, WARM_UP.size, WARM_UP.pixels());
  scratch.begin(WARM_UP.project);
  while (scratch.advance() !== undefined);
  scratch.free();
}

function post(reply: Reply, transfer: Transferable[] = []): void {
  self.postMessage(reply, transfer);
}
