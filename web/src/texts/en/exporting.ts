/** The export panel. */
import { counted, list, number, plural } from './language';

export const exporting = {
  kind: 'Kind',
  kinds: { picture: 'Picture', film: 'Film', page: 'Web page', engine: 'Engine', maps: 'Maps' },
  format: 'Format',
  size: 'Size',
  quality: 'Quality',
  background: 'Background',
  area: 'Area',
  original: 'Original',
  allOfIt: 'All of it',
  covered: 'Covered',
  /** The button. @param format such as PNG. */
  export: (format: string) => `Export ${format}`,
  exportRig: 'Export rig',
  exportMap: 'Export map',
  exportWeights: 'Export weights',
  /** A size in pixels, in numbers of the language. */
  pixels: (width: number, height: number) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width: number, height: number) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Every pixel as it is, with transparency.',
    jpeg: 'Small files of photographs, without transparency.',
    webp: 'Small files, with transparency.',
    svg: 'The drawing with bent paths, which stay sharp at any size.',
  },
  areaNotes: {
    picture: 'The rectangle of the original.',
    grown: 'Grown to hold the parts that are bent beyond the original.',
    covered: 'Only the covered part, without an empty border.',
  },
  /** A remark of the solver on a bent drawing, in English. */
  remark: (detail: string) => detail,
};

export const film = {
  noClip: 'There is no clip yet: a film shows one.',
  openTimeline: 'Open the timeline',
  clip: 'Clip',
  /** Formats without a name of their own. */
  frames: 'PNGs',
  sheet: 'Sheet',
  formatNotes: {
    webm: 'Small, with soft transparency. For web pages.',
    mp4: 'Small, without transparency. Plays nearly everywhere.',
    gif: 'Plays everywhere. 255 colours, hard edges.',
    apng: 'Every pixel as it is, with soft transparency.',
    webp: 'Every pixel as it is, smaller than an APNG.',
    frames: 'A zip of one PNG for each frame.',
    sheet: 'A zip of all frames in one PNG, with a JSON file for game engines.',
  },
  codec: (name: string) => `By ${name}.`,
  /** The film gets a column or a row more. */
  codecWithEvenSides: (name: string, width: number, height: number) =>
    `By ${name}. It has even sides: ${width} × ${height} px.`,
  gifRate: (most: number) => `A GIF gets ${most} frames a second, the most that viewers play.`,
  noCodec: (formats: readonly string[]) => `${list(formats)}: this browser does not encode it.`,
  rate: 'Rate',
  rateTip: 'Frames a second',
  allFrames: 'All frames',
  part: 'Part',
  wholeClip: 'Whole clip',
  aPart: 'A part',
  from: 'From',
  to: 'To',
  transparent: 'Transparent',
  colour: 'Colour',
  softEdgesOn: 'Soft edges on',
  frameCount: (count: number) => counted(count, 'frame'),
  /** @param size such as 5 MB. @param time such as 10 s. */
  estimate: (size: string, time: string) => `about ${size}, ${time}`,
  aFewSeconds: 'a few seconds',
  aFewSecondsLeft: 'a few seconds left',
  left: (time: string) => `about ${time} left`,
};

export const webPage = {
  note: 'One small file with all clips, for the player: a script of 14 kB that needs no editor.',
  withoutClips: 'There is no clip yet: the page shows the pose.',
  readers: 'Readers',
  watch: 'Watch clips',
  pose: 'Pose handles',
  solver: 'The page then loads another 100 kB, and the file grows by about as much.',
  code: 'Code',
  copyCode: 'Copy code',
  codeNote: 'Paste it into a page beside the file and the folder “player” of the package.',
  codeCopied: (file: string) =>
    `Copied. The code shows ${file} in a page beside it and the folder “player” of the package.`,
  codeNotCopied: 'The browser blocked the clipboard. The code is selected: copy it by hand.',
};

export const engine = {
  notes: {
    spine: 'Spine 4.2 and its runtimes: JSON, atlas and PNG.',
    dragonbones: 'DragonBones 5.5 and its runtimes: two JSON files and a PNG.',
    gltf: 'glTF 2.0 for three.js, Blender and others: one file.',
    godot: 'A scene of Godot 4 with its PNG.',
  },
  clips: (count: number) =>
    count === 0
      ? 'Mesh, bones and pose. There is no clip yet.'
      : plural(count, {
          one: 'With the clip as an animation.',
          other: `With ${count} clips as animations.`,
        }),
  rough: 'Bones blend more simply than handles, so a rig is a little off. The export tells how far.',
  bones: 'Bones',
  bonesTip: 'The most bones besides the root. Each handle has one',
  vertices: 'Vertices',
  verticesTip: 'The most vertices of the mesh',
  influences: 'Bones for each vertex',
  files: 'Files',
  zip: 'Zip',
  folder: 'Folder',
  /** The table of how far a rig is off. */
  lossCaption: (bones: number, sites: number, vertices: number) =>
    `The last rig has ${bones} bones for ${sites} sites, and ${vertices} vertices. It is off by, in pixels:`,
  largest: 'Largest',
  pose: 'Pose',
  randomPoses: 'Random poses',
  clip: (name: string) => `Clip ${name}`,
  betweenVertices: 'Between vertices',
  /** The same in a sentence. @param percentile pixels. @param largest pixels. */
  loss: (percentile: string, largest: string) =>
    `99 % of vertices are off by at most ${percentile} px, the worst by ${largest} px.`,
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
    inverse: 'An ST map for compositors: it bends other pictures as this one is bent.',
    forward: 'The way back: as an ST map on the warped picture, it takes the warp back.',
    stretch: 'How much areas and lengths grow, at each pixel of the warped picture.',
    disocclusion: 'Red where the warp uncovers something, green where it covers something.',
    heat: 'How far the picture follows a handle, in colours over the original.',
    weights: 'How far points of the original follow, as numbers for scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR with 32-bit floats. The header tells what the channels mean.',
    png: '16 bits a channel, for programs without OpenEXR.',
  },
  csvNote: 'A row for each weight above 0.',
  npyNote: 'An array for NumPy.',
  npyZipNote: 'A zip: an array for NumPy, and the list of its sites.',
  of: 'Of',
  allSites: 'All sites',
  selectedHandle: 'Selected handle',
  every: 'Pixels from point to point',
  points: (width: number, height: number) => `${number(width)} × ${number(height)} points`,
  /** @param handle the selected one. */
  selected: (handle: string) => `Selected: ${handle}.`,
};
