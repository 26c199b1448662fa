/**
 * WebM and MP4: frames are encoded by the browser (WebCodecs), and packed by mediabunny.
 *
 * WebM carries transparency as a second picture of each frame, which is encoded separately. A key frame of the colours
 * is one of the transparency too, so that players can seek. Encoders get a few frames at a time: memory stays flat.
 */

import {
  EncodedPacket,
  EncodedVideoPacketSource,
  Mp4OutputFormat,
  Output,
  StreamTarget,
  type StreamTargetChunk,
  WebMOutputFormat,
} from 'mediabunny';
import { say } from '../../texts/wording';
import type { FilmSettings } from '../filming';
import type { CodecChoice, VideoFormat } from '../video_codecs';
import { bleed } from './bleed';
import { colourOf } from './colours';
import type { FilmEncoder } from './film_encoder';
import type { FilmOutput } from './film_output';
import { Refused } from './refused';

type Bytes = Uint8Array<ArrayBuffer>;

const NO_CODEC = say('errors.writing.reasons.noCodec');
const FAILED = say('errors.writing.reasons.codecFailed');

/** Frames that wait for the encoder. */
const MOST_WAITING = 2;
/** Seconds between key frames, at which players can seek. */
const KEY_SECONDS = 2;
const MICROSECONDS = 1e6;

/** For tiny films, whose blocks have few pixels. */
const LEAST_BITS_A_SECOND = 200_000;

/** The encoded colours of a frame, until its transparency arrives. */
interface Coloured {
  readonly chunk: EncodedVideoChunk;
  readonly meta: EncodedVideoChunkMetadata | undefined;
}

export class VideoFilm implements FilmEncoder {
  readonly #settings: FilmSettings;
  readonly #codec: CodecChoice;
  readonly #packer: Output;
  readonly #source: EncodedVideoPacketSource;
  readonly #colours: VideoEncoder;
  readonly #alphas: VideoEncoder | null;
  /** Transparency of frames whose colours are being encoded. */
  readonly #waiting: VideoFrame[] = [];
  readonly #coloured: Coloured[] = [];
  #packing: Promise<void> = Promise.resolve();
  #failure: Error | null = null;
  /** Tells of progress or failure. */
  #moved: () => void = () => {};
  #frame = 0;

  private constructor(settings: FilmSettings, format: VideoFormat, codec: CodecChoice, output: FilmOutput) {
    this.#settings = settings;
    this.#codec = codec;
    const writable = new WritableStream<StreamTargetChunk>({
      write: ({ position, data }) => output.write(position, data.slice()),
    });
    const container = format === 'webm' ? new WebMOutputFormat() : new Mp4OutputFormat({ fastStart: false });
    const target = new StreamTarget(writable, { chunked: true, chunkSize: 2 ** 20 });
    this.#packer = new Output({ format: container, target });
    this.#source = new EncodedVideoPacketSource(codec.codec);
    const canBeTransparent = format === 'webm' && settings.background === null;
    this.#packer.addVideoTrack(this.#source, { frameRate: settings.rate, canBeTransparent });
    this.#colours = this.#encoder((chunk, meta) => this.#takeColours({ chunk, meta }));
    this.#alphas = canBeTransparent ? this.#encoder((chunk) => this.#takeAlpha(chunk)) : null;
  }

  /** @throws Refused if the browser lacks the codec. */
  static async begin(settings: FilmSettings, format: VideoFormat, output: FilmOutput): Promise<VideoFilm> {
    if (!settings.codec || typeof VideoEncoder === 'undefined') throw new Refused(NO_CODEC);
    const film = new VideoFilm(settings, format, settings.codec, output);
    await film.#packer.start();
    return film;
  }

  async add(rgba: Bytes): Promise<void> {
    const { rate, background, width, height } = this.#settings;
    const timestamp = Math.round((this.#frame * MICROSECONDS) / rate);
    const duration = Math.round(((this.#frame + 1) * MICROSECONDS) / rate) - timestamp;
    const keyFrame = this.#frame % Math.max(1, Math.round(KEY_SECONDS * rate)) === 0;
    this.#frame += 1;
    const size = { codedWidth: this.#codec.width, codedHeight: this.#codec.height };
    const times = { timestamp, duration };
    if (this.#alphas) {
      this.#waiting.push(new VideoFrame(alphaOf(rgba, width, height), { format: 'I420', ...size, ...times }));
      bleed(rgba, width, height);
    }
    const whole = this.#codec.width === width && this.#codec.height === height;
    const padded = whole ? rgba : enlarged(rgba, width, height, this.#codec, background ?? '#000000');
    const frame = new VideoFrame(padded, { format: 'RGBX', ...size, ...times });
    this.#check();
    this.#colours.encode(frame, { keyFrame });
    frame.close();
    await this.#until(() => this.#colours.encodeQueueSize < MOST_WAITING && this.#lag < 2 * MOST_WAITING);
    await this.#packing;
    this.#check();
  }

  async finish(): Promise<void> {
    await this.#flush(this.#colours);
    if (this.#alphas) await this.#flush(this.#alphas);
    await this.#packing;
    this.#check();
    await this.#packer.finalize();
  }

  dispose(): void {
    for (const encoder of [this.#colours, this.#alphas]) if (encoder?.state !== 'closed') encoder?.close();
    for (const frame of this.#waiting) frame.close();
    this.#waiting.length = 0;
    // Its output is abandoned too.
    if (this.#packer.state === 'started') this.#packer.cancel().catch(() => {});
  }

  /** Frames with colours that wait for their transparency. */
  get #lag(): number {
    return this.#coloured.length;
  }

  #encoder(output: EncodedVideoChunkOutputCallback): VideoEncoder {
    const { rate, bits } = this.#settings;
    const { config: codec, width, height } = this.#codec;
    const encoder = new VideoEncoder({
      output: (chunk, meta) => {
        output(chunk, meta);
        this.#moved();
      },
      error: () => this.#fail(new Refused(FAILED)),
    });
    encoder.addEventListener('dequeue', () => this.#moved());
    const bitrate = Math.max(LEAST_BITS_A_SECOND, Math.round(width * height * rate * bits));
    encoder.configure({ codec, width, height, bitrate, framerate: rate, latencyMode: 'quality' });
    return encoder;
  }

  #takeColours(coloured: Coloured): void {
    if (!this.#alphas) {
      this.#pack(coloured, null);
      return;
    }
    const alpha = this.#waiting.shift();
    if (!alpha || this.#alphas.state !== 'configured') return;
    this.#coloured.push(coloured);
    this.#alphas.encode(alpha, { keyFrame: coloured.chunk.type === 'key' });
    alpha.close();
  }

  #takeAlpha(chunk: EncodedVideoChunk): void {
    const coloured = this.#coloured.shift();
    if (coloured) this.#pack(coloured, chunk);
  }

  #pack({ chunk, meta }: Coloured, alpha: EncodedVideoChunk | null): void {
    const packet = EncodedPacket.fromEncodedChunk(chunk, alpha ? { alpha: bytesOf(alpha) } : undefined);
    this.#packing = this.#packing
      .then(() => this.#source.add(packet, meta))
      .catch((error: unknown) => this.#fail(asFailure(error)));
  }

  async #flush(encoder: VideoEncoder): Promise<void> {
    this.#check();
    try {
      await encoder.flush();
    } catch {
      this.#check();
      throw new Refused(FAILED);
    }
  }

  #fail(error: Error): void {
    this.#failure ??= error;
    this.#moved();
  }

  #check(): void {
    if (this.#failure) throw this.#failure;
  }

  async #until(done: () => boolean): Promise<void> {
    while (!done() && !this.#failure)
      await new Promise<void>((resolve) => {
        this.#moved = resolve;
      });
    this.#check();
  }
}

/** Refusals of the output pass through the packer. */
const asFailure = (error: unknown): Error => (error instanceof Refused ? error : new Refused(FAILED));

function bytesOf(chunk: EncodedVideoChunk): Uint8Array {
  const bytes = new Uint8Array(chunk.byteLength);
  chunk.copyTo(bytes);
  return bytes;
}

/** The transparency as the brightness of a grey picture, in planes. */
function alphaOf(rgba: Bytes, width: number, height: number): Bytes {
  const count = width * height;
  const planes = new Uint8Array(count + 2 * Math.ceil(width / 2) * Math.ceil(height / 2));
  for (let pixel = 0, at = 3; pixel < count; pixel++, at += 4) planes[pixel] = rgba[at] as number;
  planes.fill(128, count);
  return planes;
}

/** The picture in the upper left corner of a larger one. */
function enlarged(rgba: Bytes, width: number, height: number, to: CodecChoice, background: string): Bytes {
  const out = new Uint8Array(4 * to.width * to.height);
  const below = [...colourOf(background), 255];
  for (let at = 0; at < out.length; at += 4) out.set(below, at);
  for (let y = 0; y < height; y++)
    out.set(rgba.subarray(4 * y * width, 4 * (y + 1) * width), 4 * y * to.width);
  return out;
}
