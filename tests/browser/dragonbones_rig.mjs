/** The runtime of DragonBones, as published for PixiJS, without a screen: it poses a rig, and returns its vertices. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { createContext, runInContext } from 'node:vm';

/**
 * The parts of PixiJS that the runtime needs to hold a mesh. Nothing is drawn. The runtime extends functions, not
 * classes.
 */
const SCREENLESS = `
  function Display() {
    this.uvBuffer = { update: function () {} };
    this.geometry = { addIndex: function () {} };
  }
  for (const name of ['setTransform', 'addChild', 'removeChild', 'swapChildren'])
    Display.prototype[name] = function () {};
  Display.prototype.listenerCount = function () { return 0; };
  function Mesh() {
    return Display.call(this) || this;
  }
  Mesh.prototype = Object.create(Display.prototype);
  function Plain() {}
  var PIXI = {
    VERSION: '5', BLEND_MODES: {}, Container: Display, Graphics: Display, Sprite: Display, SimpleMesh: Mesh,
    Texture: Plain, BaseTexture: Plain, Rectangle: Plain, Matrix: Plain,
  };
  var window = {};
`;

/**
 * Loads the two files of a rig.
 *
 * `durations`: of clips by their names, in seconds. `vertices`: x and y of all vertices in the pose of the file, or at
 * a time of a clip.
 *
 * @param {string} skeleton
 * @param {string} texture
 */
export function dragonBonesRig(skeleton, texture) {
  const script = readFileSync(createRequire(import.meta.url).resolve('pixi5-dragonbones'), 'utf8');
  const silent = { log() {}, info() {}, warn() {} };
  const { PixiFactory } = runInContext(
    `${SCREENLESS}${script}; dragonBones`,
    createContext({ console: silent }),
  );
  const factory = new PixiFactory(null, false);
  const { name, armatureNames } = factory.parseDragonBonesData(JSON.parse(skeleton));
  factory.parseTextureAtlasData(JSON.parse(texture), {});
  const armature = factory.buildArmature(armatureNames[0], name);
  const { animation } = armature;
  /** @type {Record<string, number>} */
  const durations = {};
  for (const clip of animation.animationNames) durations[clip] = animation.animations[clip].duration;
  /** @type {(clip?: string, seconds?: number) => number[]} */
  const vertices = (clip, seconds = 0) => {
    if (clip !== undefined) animation.gotoAndStopByTime(clip, seconds);
    armature.invalidUpdate(null, true);
    armature.advanceTime(0);
    return [...armature.getSlots()[0]._renderDisplay.vertices];
  };
  return { durations, vertices };
}
