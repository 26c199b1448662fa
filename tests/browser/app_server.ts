/** The editor as a host serves it: in a folder, in versions that follow one another, and with failures. */
import { readFile } from 'node:fs/promises';
import { createServer, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { builtFiles } from '../../web/scripts/built_files.mjs';
import { contentType } from '../../web/scripts/content_types.mjs';

const PUBLIC = new URL('../../web/public/', import.meta.url);
const CONFIG = fileURLToPath(new URL('../../web/vite.config.ts', import.meta.url));

/** Not the root: the editor works in any folder. */
const FOLDER = '/tools/editor/';

/** The strictest policy that the editor works under. */
const POLICY = `
  default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; connect-src 'self';
  img-src 'self' blob: data:; media-src blob:; manifest-src 'self'; base-uri 'none';
  require-trusted-types-for 'script'; trusted-types c2warp-html c2warp`.replaceAll(/\s+/g, ' ');

export type Files = ReadonlyMap<string, string | Uint8Array>;

/** The scripts that report their version: one of the page, and one that is loaded later. */
const MARKED = { main: '/src/main.ts', study: '/ui/study/study.ts' };

/** Builds a version of the editor whose scripts set the version on `globalThis`. */
export async function builtEditor(version: string): Promise<Files> {
  const { NODE_ENV } = process.env;
  process.env.NODE_ENV = 'production';
  const files = await builtFiles({
    configFile: CONFIG,
    logLevel: 'error',
    plugins: [
      {
        name: 'version',
        transform(code, id) {
          const marked = Object.entries(MARKED).find(([, file]) => id.endsWith(file));
          return marked && `${code}\nReflect.set(globalThis, '${marked[0]}Version', '${version}');`;
        },
      },
    ],
  });
  if (NODE_ENV === undefined) delete process.env.NODE_ENV;
  else process.env.NODE_ENV = NODE_ENV;
  return files;
}

export class AppServer {
  /** The address of the editor. */
  readonly home: string;
  /** The requested paths, in the folder. */
  readonly asked: string[] = [];
  /** Paths that the server answers with this status, as often as it says. */
  readonly failures = new Map<string, { readonly status: number; times: number }>();
  #files: Files;
  #server: Server;
  readonly #port: number;

  private constructor(files: Files, server: Server) {
    this.#files = files;
    this.#server = server;
    this.#port = (server.address() as AddressInfo).port;
    this.home = `http://localhost:${this.#port}${FOLDER}`;
  }

  static async start(files: Files): Promise<AppServer> {
    const server = await listening(createServer(), 0);
    const started = new AppServer(files, server);
    started.#serve();
    return started;
  }

  /** Replaces the present version with another one. */
  deploy(files: Files): void {
    this.#files = files;
  }

  /** From here on, the network is off. */
  stop(): Promise<void> {
    const stopped = new Promise<void>((done) => this.#server.close(() => done()));
    this.#server.closeAllConnections();
    return stopped;
  }

  async restart(): Promise<void> {
    this.#server = await listening(createServer(), this.#port);
    this.#serve();
  }

  #serve(): void {
    this.#server.on('request', ({ url = '' }, response) => this.#answer(url, response));
  }

  async #answer(url: string, response: ServerResponse): Promise<void> {
    const { pathname } = new URL(url, this.home);
    const path = pathname.startsWith(FOLDER) ? pathname.slice(FOLDER.length) : `..${pathname}`;
    this.asked.push(path);
    const name = path === '' ? 'index.html' : path;
    const failure = this.failures.get(path);
    if (failure && failure.times-- > 0) {
      response.writeHead(failure.status).end();
      return;
    }
    const content = this.#files.get(name) ?? (await readFile(new URL(name, PUBLIC)).catch(() => null));
    if (content === null) response.writeHead(404).end();
    else
      response
        .writeHead(200, {
          'Content-Type': contentType(name),
          'Content-Security-Policy': POLICY,
          'Cache-Control': 'max-age=600',
        })
        .end(content);
  }
}

const listening = (server: Server, port: number): Promise<Server> =>
  new Promise((done) => server.listen(port, 'localhost', () => done(server)));
