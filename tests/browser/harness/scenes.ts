/** Draws pictures by WebGL and by the solver, for comparison. */
import { Engine } from '../../../web/src/compute/engine';
import type { Pixels } from '../../../web/src/compute/solution';
import type { Project } from '../../../web/src/document/project';
import { Renderer } from '../../../web/src/render/renderer';
import { fillPatch } from '../../../web/src/runtime/fill_patch';
import { drawnPicture } from './drawn_picture';
import { encodePng } from './encoded';
import { decodePicture } from './pictures';

/**
 * Draws a project by WebGL and by the solver's rasteriser. Returns PNG files in base64, in straight alpha.
 *
 * @param time the time of the project's first clip whose pose WebGL draws; the handles are posed as at that time.
 */
export async function drawnTwice(project: Project, file: Blob, scale: number, time?: number) {
  const picture = await decodePicture(file);
  const engine = await Engine.start();
  engine.setPicture(picture);
  const solution = await engine.solve(project);
  const posed = engine.posedPicture(solution, project);
  const clip = project.clips?.[0];
  const pose =
    clip && time !== undefined ? posed.playback(clip, project).pose(project, time) : posed.pose(project);

  const renderer = new Renderer(document.createElement('canvas'));
  renderer.setPicture(picture);
  const fill = await engine.fill(project, () => {});
  if (fill) renderer.setFill(await fillPatch(fill));
  renderer.setSolution(solution);
  renderer.setPlaces(pose.places);
  const crossed = project.edges ? pose.crossed() : null;
  renderer.setMotions(pose.motions, project.pose?.blend, pose.triangles, crossed);
  const [width, height] = [Math.round(picture.width * scale), Math.round(picture.height * scale)];
  const webgl = straight(renderer.readPixels({ scale, x: 0, y: 0, width, height }));
  const cpu = await drawnPixels(engine, project, scale);
  engine.dispose();
  renderer.dispose();
  return {
    webgl: await base64(await encodePng(width, height, webgl)),
    cpu: await base64(await encodePng(cpu.width, cpu.height, cpu.rgba)),
  };
}

/** Returns the picture that an export of a project has. */
export async function drawnPixels(engine: Engine, project: Project, scale = 1): Promise<Pixels> {
  const drawing = await engine.draw(project, { scale, area: 'picture', pixelated: false });
  return drawing.pixels();
}

function straight(premultiplied: Uint8Array): Uint8Array<ArrayBuffer> {
  return premultiplied.map((value, i) => {
    const alpha = premultiplied[i | 3] ?? 0;
    return i % 4 === 3 || alpha === 0 ? value : Math.min(255, Math.round((value * 255) / alpha));
  });
}

function base64(blob: Blob): Promise<string> {
  return new Promise((resolve) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result).replace(/^.*,/, ''));
    reader.readAsDataURL(blob);
  });
}

/** Returns an engine with the test picture. */
export async function startedEngine(): Promise<Engine> {
  const picture = await decodePicture(await drawnPicture());
  const engine = await Engine.start();
  engine.setPicture(picture);
  return engine;
}
