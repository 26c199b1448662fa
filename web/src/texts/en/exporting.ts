/** The export panel. */
import { counted, list, number, plural } from './language';

export const exporting = {
  kind: 'Type',
  kinds: { picture: 'Picture', film: 'Film', page: 'Web page', engine: 'Engine', maps: 'Maps' },
  format: 'Format',
  size: 'Size',
  quality: 'Quality',
  background: 'Background',
  area: 'Area',
  original: 'Original',
  allOfIt: 'Expanded',
  covered: 'Trimmed',
  /** The button. @param format such as PNG. */
  export: (format: string) => `Export ${format}`,
  exportRig: 'Export rig',
  exportMap: 'Export map',
  exportWeights: 'Export weights',
  /** A size in pixels, in numbers of the language. */
  pixels: (width: number, height: number) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width: number, height: number) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Lossless, with transparency.',
    jpeg: 'Small files for photographs, without transparency.',
    webp: 'Small files, with transparency.',
    svg: 'The drawing with bent paths. It stays sharp at any size.',
  },
  areaNotes: {
    picture: 'The frame of the original picture.',
    grown: 'Expanded to include parts bent beyond the original frame.',
    covered: 'Trimmed to the visible part, without an empty border.',
  },
  /** A remark of the solver on a bent drawing, in English. */
  remark: (detail: string) => detail,
};

export const film = {
  noClip: 'A film needs a clip. Add one in the timeline.',
  openTimeline: 'Open the timeline',
  clip: 'Clip',
  /** Formats without a name of their own. */
  frames: 'PNGs',
  sheet: 'Sheet',
  formatNotes: {
    webm: 'Small files with soft transparency, for web pages.',
    mp4: 'Small files without transparency. Plays nearly everywhere.',
    gif: 'Plays everywhere, but has only 255 colours and hard edges.',
    apng: 'Lossless, with soft transparency.',
    webp: 'Lossless, and smaller than APNG.',
    frames: 'A zip with one PNG per frame.',
    sheet: 'A zip with a sprite sheet: all frames in one PNG, and a JSON file for game engines.',
  },
  codec: (name: string) => `Codec: ${name}.`,
  /** The film gets a column or a row more. */
  codecWithEvenSides: (name: string, width: number, height: number) =>
    `Codec: ${name}. Width and height are rounded up to even numbers: ${width} × ${height} px.`,
  gifRate: (most: number) => `GIFs are limited to ${most} frames per second, the most that viewers play.`,
  noCodec: (formats: readonly string[]) => `This browser cannot encode ${list(formats)}.`,
  rate: 'Rate',
  rateTip: 'Frames per second',
  allFrames: 'Expanded',
  part: 'Range',
  wholeClip: 'Whole clip',
  aPart: 'Part of clip',
  from: 'From',
  to: 'To',
  transparent: 'Transparent',
  colour: 'Colour',
  softEdgesOn: 'Matte colour',
  frameCount: (count: number) => counted(count, 'frame'),
  /** @param size such as 5 MB. @param time such as 10 s. */
  estimate: (size: string, time: string) => `about ${size}, ${time}`,
  aFewSeconds: 'a few seconds',
  aFewSecondsLeft: 'a few seconds left',
  left: (time: string) => `about ${time} left`,
};

export const webPage = {
  note: 'One small file with all clips. A 15 kB player script shows it without the editor.',
  withoutClips: 'Without a clip, the page shows the current pose.',
  readers: 'Visitors can',
  watch: 'Watch clips',
  pose: 'Pose handles',
  solver: 'Posing adds about 100 kB to the file and another 100 kB to the page.',
  code: 'Code',
  copyCode: 'Copy code',
  codeNote: 'Paste this into a page. Put the file and the package’s “player” folder beside the page.',
  codeCopied: (file: string) => `Copied. Put ${file} and the package’s “player” folder beside the page.`,
  codeNotCopied: 'The browser blocked the clipboard. Copy the selected code yourself.',
};

export const engine = {
  notes: {
    spine: 'For Spine 4.2 and its runtimes: JSON, atlas and PNG.',
    dragonbones: 'For DragonBones 5.5 and its runtimes: two JSON files and a PNG.',
    gltf: 'glTF 2.0 for three.js, Blender and others, in one file.',
    godot: 'A Godot 4 scene with its PNG.',
  },
  clips: (count: number) =>
    count === 0
      ? 'Contains the mesh, bones and pose. Add a clip to include an animation.'
      : plural(count, {
          one: 'Includes the clip as an animation.',
          other: `Includes ${count} clips as animations.`,
        }),
  rough: 'Bones only approximate handles, so the rig differs slightly. The export reports by how much.',
  bones: 'Bones',
  bonesTip: 'Maximum number of bones, not counting the root',
  vertices: 'Vertices',
  verticesTip: 'Maximum number of mesh vertices',
  influences: 'Bones per vertex',
  files: 'Files',
  zip: 'Zip',
  folder: 'Folder',
  /** The table of the errors of a rig. @param sites handles and helper points. */
  lossCaption: (bones: number, sites: number, vertices: number) =>
    `The last rig uses ${bones} bones for ${sites} handles and helper points, and ${vertices} vertices. Error in pixels:`,
  largest: 'Largest',
  pose: 'Pose',
  randomPoses: 'Random poses',
  clip: (name: string) => `Clip ${name}`,
  betweenVertices: 'Between vertices',
  /** The same in a sentence. @param percentile pixels. @param largest pixels. */
  loss: (percentile: string, largest: string) =>
    `99 % of vertices are within ${percentile} px. The largest error is ${largest} px.`,
};

export const maps = {
  map: 'Map',
  names: {
    inverse: 'Inverse',
    forward: 'Forward',
    stretch: 'Stretch',
    disocclusion: 'Disocclusion',
    heat: 'Heat map',
    weights: 'Weights',
  },
  notes: {
    inverse: 'An ST map for compositors. It applies this warp to other pictures.',
    forward: 'An ST map that undoes the warp when applied to the warped picture.',
    stretch: 'How much areas and lengths grow at each pixel of the warped picture.',
    disocclusion: 'Red where the warp uncovers an area, green where it covers one.',
    heat: 'How closely the picture follows a handle, in colours over the original.',
    weights: 'How closely points of the original follow each handle, as numbers for scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR with 32-bit floats. The header describes the channels.',
    png: '16 bits per channel, for programs without OpenEXR.',
  },
  csvNote: 'One row for each weight above 0.',
  npyNote: 'A NumPy array.',
  npyZipNote: 'A zip with a NumPy array, and the list of its handles and helper points.',
  of: 'Weights of',
  allSites: 'All handles',
  selectedHandle: 'Selected handle',
  every: 'Spacing in pixels',
  points: (width: number, height: number) => `${number(width)} × ${number(height)} points`,
  /** @param handle the selected one. */
  selected: (handle: string) => `Selected: ${handle}.`,
};
