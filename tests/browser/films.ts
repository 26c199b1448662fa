/** Films as other decoders read them, and frames as the command draws them. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import { builtCommand } from './command';

/** Straight RGBA. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: ArrayLike<number>;
}

/** A film as the browser plays it. */
export interface Decoded {
  /** Of an animated picture; null for a video. */
  readonly frames: number | null;
  /** Seconds of a video, or of the first frame of an animated picture. */
  readonly seconds: number;
  readonly shown: readonly Pixels[];
}

/** Decodes some frames of an animated picture. */
export function decodePicture(
  page: Page,
  file: Buffer,
  type: string,
  frames: readonly number[],
): Promise<Decoded> {
  return inPage(page, { base64: file.toString('base64'), type, wanted: frames, video: false });
}

/** Decodes a video at some times, in seconds. */
export function decodeVideo(
  page: Page,
  file: Buffer,
  type: string,
  times: readonly number[],
): Promise<Decoded> {
  return inPage(page, { base64: file.toString('base64'), type, wanted: times, video: true });
}

interface Wanted {
  readonly base64: string;
  readonly type: string;
  readonly wanted: readonly number[];
  readonly video: boolean;
}

/** In a page of its own, so that the policy of the editor's page does not apply. */
async function inPage(page: Page, wanted: Wanted): Promise<Decoded> {
  const player = await page.context().newPage();
  await player.route('**/player-of-films', (route) =>
    route.fulfill({ contentType: 'text/html', body: '<!doctype html>' }),
  );
  try {
    await player.goto('/player-of-films');
    return await player.evaluate(async ({ base64, type, wanted, video }) => {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      const pixels = (source: CanvasImageSource, width: number, height: number) => {
        const context = new OffscreenCanvas(width, height).getContext('2d');
        context?.drawImage(source, 0, 0);
        return { width, height, data: Array.from(context?.getImageData(0, 0, width, height).data ?? []) };
      };
      const shown = [];
      if (video) {
        const element = document.createElement('video');
        element.src = URL.createObjectURL(new Blob([bytes], { type }));
        await new Promise((done, failed) => {
          element.onloadeddata = done;
          element.onerror = () => failed(new Error(element.error?.message));
        });
        for (const time of wanted) {
          // `seeked` may come before the frame can be drawn.
          const presented = new Promise((done) => element.requestVideoFrameCallback(done));
          const seeked = new Promise((done) => {
            element.onseeked = done;
          });
          element.currentTime = time;
          await Promise.all([presented, seeked]);
          shown.push(pixels(element, element.videoWidth, element.videoHeight));
        }
        return { frames: null, seconds: element.duration, shown };
      }
      const decoder = new ImageDecoder({ data: bytes, type });
      await decoder.tracks.ready;
      await decoder.completed;
      let seconds = 0;
      for (const frameIndex of wanted) {
        const { image } = await decoder.decode({ frameIndex });
        seconds = (image.duration ?? 0) / 1e6;
        shown.push(pixels(image, image.displayWidth, image.displayHeight));
      }
      return { frames: decoder.tracks.selectedTrack?.frameCount ?? 0, seconds, shown };
    }, wanted);
  } finally {
    await player.close();
  }
}

/** A time of a clip as `c2warp warp` draws it. */
export function drawnByCommand(
  project: string,
  image: string,
  clip: string,
  seconds: number,
  scale: number,
  more: readonly string[] = [],
): Pixels {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-'));
  try {
    const [file, out] = [join(folder, 'a.c2warp.json'), join(folder, 'out.png')];
    writeFileSync(file, project);
    const when = ['--clip', clip, '--at', String(seconds), '--scale', String(scale)];
    const args = ['warp', file, '--image', image, ...when, ...more, '-o', out];
    const { stderr, status } = spawnSync(builtCommand(), args, { encoding: 'utf8' });
    if (status !== 0) throw new Error(stderr);
    return decode(readFileSync(out)) as Pixels;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The mean difference of two pictures in 255ths, over all channels, of colours times their opacity. */
export function apart(a: Pixels, b: Pixels, over: readonly number[] | null = null): number {
  if (a.width !== b.width || a.height !== b.height)
    throw new Error(`${a.width} × ${a.height} px are not ${b.width} × ${b.height} px`);
  let sum = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const [left, right] = [premultiplied(a, at, over), premultiplied(b, at, over)];
    for (let channel = 0; channel < 4; channel++)
      sum += Math.abs((left[channel] ?? 0) - (right[channel] ?? 0));
  }
  return sum / a.data.length;
}

/** @param over the colour below; null leaves the transparency. */
function premultiplied({ data }: Pixels, at: number, over: readonly number[] | null): readonly number[] {
  const alpha = Number(data[at + 3]) / 255;
  const colours = [0, 1, 2].map(
    (channel) => Number(data[at + channel]) * alpha + (over?.[channel] ?? 0) * (1 - alpha),
  );
  return [...colours, over ? 255 : 255 * alpha];
}
