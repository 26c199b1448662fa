/** A proxy that records the requests of a browser: pages, workers and service workers alike. */
import { createServer, request as forward, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';

export class RecordingProxy {
  /** The addresses of requests, or only the host for encrypted connections. */
  readonly asked: string[] = [];
  readonly #server: Server;

  private constructor(server: Server) {
    this.#server = server;
    server.on('request', (request, response) => {
      const { url = '', method, headers } = request;
      this.asked.push(url);
      const onward = forward(url, { method, headers }, (answer) => {
        response.writeHead(answer.statusCode ?? 502, answer.headers);
        answer.pipe(response);
      });
      onward.on('error', () => response.writeHead(502).end());
      request.pipe(onward);
    });
    server.on('connect', ({ url = '' }, socket) => {
      this.asked.push(url);
      socket.end('HTTP/1.1 502 Bad Gateway\r\n\r\n');
    });
  }

  static async start(): Promise<RecordingProxy> {
    const server = createServer();
    await new Promise<void>((done) => server.listen(0, 'localhost', () => done()));
    return new RecordingProxy(server);
  }

  get address(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}`;
  }

  stop(): void {
    this.#server.close();
    this.#server.closeAllConnections();
  }
}
