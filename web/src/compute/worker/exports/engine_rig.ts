/** A rig for a game engine: its files, and its loss in numbers. */
import type { EngineLoss, Errors } from '../../../document/engine_rig';
import type { EngineRig, EngineRigOrder, ExportRequest } from '../../exporting_messages';
import { type EngineFiles, EngineFormat, EngineOptions, engine_rig } from '../../generated/c2warp_export';
import { zipped } from './zip';

const FORMATS: Readonly<Record<EngineRigOrder['format'], EngineFormat>> = {
  spine: EngineFormat.Spine,
  dragonbones: EngineFormat.DragonBones,
  gltf: EngineFormat.Gltf,
  godot: EngineFormat.Godot,
};

/** @throws Error for options that do not fit the picture. */
export function engineRig(
  { project, width, height }: ExportRequest,
  { format, bones, influences, vertices, stem, zip }: EngineRigOrder,
  rgba: Uint8Array,
  onProgress: (part: number) => void,
): EngineRig {
  const options = new EngineOptions(FORMATS[format], bones, influences, vertices);
  const rig = engine_rig(project, width, height, rgba, stem, options, onProgress);
  const files = rig.names.map((name, file) => ({
    name,
    bytes: rig.bytes(file) as Uint8Array<ArrayBuffer>,
  }));
  return { files: zip === null ? files : [{ name: zip, bytes: zipped(files) }], loss: lossOf(rig) };
}

function lossOf({ sizes, errors }: EngineFiles): EngineLoss {
  const [bones = 0, sites = 0, vertices = 0] = sizes;
  const pairs = Array.from(
    { length: errors.length / 2 },
    (_, k): Errors => [errors[2 * k] ?? 0, errors[2 * k + 1] ?? 0],
  );
  const none: Errors = [0, 0];
  const [pose = none, random = none] = pairs;
  return { bones, sites, vertices, pose, random, clips: pairs.slice(2, -1), between: pairs.at(-1) ?? none };
}
