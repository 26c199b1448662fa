import type { Texts } from '../texts';
import { counted, list, number, plural } from './language';

export const exporting: Texts['exporting'] = {
  kind: 'Art',
  kinds: { picture: 'Bild', film: 'Film', page: 'Webseite', engine: 'Engine', maps: 'Karten' },
  format: 'Format',
  size: 'Größe',
  quality: 'Qualität',
  background: 'Hintergrund',
  area: 'Bereich',
  original: 'Original',
  allOfIt: 'Alles',
  covered: 'Bedeckt',
  export: (format) => `${format} exportieren`,
  exportRig: 'Rig exportieren',
  exportMap: 'Karte exportieren',
  exportWeights: 'Gewichte exportieren',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Jedes Pixel, wie es ist, mit Transparenz.',
    jpeg: 'Kleine Dateien von Fotos, ohne Transparenz.',
    webp: 'Kleine Dateien, mit Transparenz.',
    svg: 'Die Zeichnung mit gebogenen Pfaden, die in jeder Größe scharf bleiben.',
  },
  areaNotes: {
    picture: 'Das Rechteck des Originals.',
    grown: 'Vergrößert, damit auch Teile Platz haben, die über das Original hinaus gebogen sind.',
    covered: 'Nur der bedeckte Teil, ohne leeren Rand.',
  },
  remark: (detail) => `Hinweis: ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Es gibt noch keinen Clip: Ein Film zeigt einen.',
  openTimeline: 'Zeitleiste öffnen',
  clip: 'Clip',
  frames: 'PNGs',
  sheet: 'Bogen',
  formatNotes: {
    webm: 'Klein, mit weicher Transparenz. Für Webseiten.',
    mp4: 'Klein, ohne Transparenz. Läuft fast überall.',
    gif: 'Läuft überall. 255 Farben, harte Kanten.',
    apng: 'Jedes Pixel, wie es ist, mit weicher Transparenz.',
    webp: 'Jedes Pixel, wie es ist, kleiner als ein APNG.',
    frames: 'Ein Zip mit einem PNG je Einzelbild.',
    sheet: 'Ein Zip mit allen Einzelbildern in einem PNG und einer JSON-Datei für Spiele-Engines.',
  },
  codec: (name) => `Mit ${name}.`,
  codecWithEvenSides: (name, width, height) =>
    `Mit ${name}. Die Seiten sind gerade: ${width} × ${height} px.`,
  gifRate: (most) => `Ein GIF bekommt ${most} Bilder je Sekunde, mehr spielen Betrachter nicht ab.`,
  noCodec: (formats) => `${list(formats)}: Dieser Browser kann das nicht kodieren.`,
  rate: 'Bildrate',
  rateTip: 'Bilder je Sekunde',
  allFrames: 'Alle Einzelbilder',
  part: 'Teil',
  wholeClip: 'Ganzer Clip',
  aPart: 'Ein Teil',
  from: 'Von',
  to: 'Bis',
  transparent: 'Transparent',
  colour: 'Farbe',
  softEdgesOn: 'Weiche Kanten auf',
  frameCount: (count) => counted(count, 'Einzelbild', 'Einzelbilder'),
  estimate: (size, time) => `etwa ${size}, ${time}`,
  aFewSeconds: 'ein paar Sekunden',
  aFewSecondsLeft: 'noch ein paar Sekunden',
  left: (time) => `noch etwa ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: 'Eine kleine Datei mit allen Clips für den Player: ein Skript von 14 kB, das keinen Editor braucht.',
  withoutClips: 'Es gibt noch keinen Clip: Die Seite zeigt die Pose.',
  readers: 'Leser',
  watch: 'Clips ansehen',
  pose: 'Griffe bewegen',
  solver: 'Die Seite lädt dann weitere 100 kB, und die Datei wächst um etwa ebenso viel.',
  code: 'Code',
  copyCode: 'Code kopieren',
  codeNote: 'In eine Seite einfügen, neben der die Datei und der Ordner „player“ des Pakets liegen.',
  codeCopied: (file) =>
    `Kopiert. Der Code zeigt ${file} in einer Seite, neben der die Datei und der Ordner „player“ des Pakets liegen.`,
  codeNotCopied: 'Der Browser hat die Zwischenablage gesperrt. Der Code ist markiert: von Hand kopieren.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Spine 4.2 und seine Laufzeiten: JSON, Atlas und PNG.',
    dragonbones: 'DragonBones 5.5 und seine Laufzeiten: zwei JSON-Dateien und ein PNG.',
    gltf: 'glTF 2.0 für three.js, Blender und andere: eine Datei.',
    godot: 'Eine Szene für Godot 4 mit ihrem PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Netz, Knochen und Pose. Es gibt noch keinen Clip.'
      : plural(count, {
          one: 'Mit dem Clip als Animation.',
          other: `Mit ${count} Clips als Animationen.`,
        }),
  rough:
    'Knochen mischen einfacher als Griffe, darum weicht ein Rig etwas ab. Der Export nennt die Abweichung.',
  bones: 'Knochen',
  bonesTip: 'Höchste Zahl der Knochen außer der Wurzel; jeder Griff hat einen',
  vertices: 'Eckpunkte',
  verticesTip: 'Höchste Zahl der Eckpunkte des Netzes',
  influences: 'Knochen je Eckpunkt',
  files: 'Dateien',
  zip: 'Zip',
  folder: 'Ordner',
  lossCaption: (bones, sites, vertices) =>
    `Das letzte Rig hat Knochen: ${bones}, für Stützstellen: ${sites}, und Eckpunkte: ${vertices}. Es weicht ab um, in Pixeln:`,
  largest: 'Größte',
  pose: 'Pose',
  randomPoses: 'Zufallsposen',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Zwischen Eckpunkten',
  loss: (percentile, largest) =>
    `99 % der Eckpunkte weichen höchstens ${percentile} px ab, der schlechteste ${largest} px.`,
};

export const maps: Texts['maps'] = {
  map: 'Karte',
  names: {
    inverse: 'Invers',
    forward: 'Vorwärts',
    stretch: 'Dehnung',
    disocclusion: 'Aufdeckung',
    heat: 'Wärmekarte',
    weights: 'Gewichte',
  },
  notes: {
    inverse: 'Eine ST-Karte für Compositing: Sie biegt andere Bilder so, wie dieses gebogen ist.',
    forward: 'Der Rückweg: Als ST-Karte auf dem verbogenen Bild nimmt sie die Biegung zurück.',
    stretch: 'Wie stark Flächen und Längen wachsen, an jedem Pixel des verbogenen Bilds.',
    disocclusion: 'Rot, wo die Biegung etwas aufdeckt, grün, wo sie etwas verdeckt.',
    heat: 'Wie weit das Bild einem Griff folgt, in Farben über dem Original.',
    weights: 'Wie weit Punkte des Originals folgen, als Zahlen für Skripte.',
  },
  formatNotes: {
    exr: 'OpenEXR mit 32-Bit-Gleitkommazahlen. Der Dateikopf nennt die Bedeutung der Kanäle.',
    png: '16 Bit je Kanal, für Programme ohne OpenEXR.',
  },
  csvNote: 'Eine Zeile für jedes Gewicht über 0.',
  npyNote: 'Ein Array für NumPy.',
  npyZipNote: 'Ein Zip: ein Array für NumPy und die Liste seiner Stützstellen.',
  of: 'Von',
  allSites: 'Alle Stützstellen',
  selectedHandle: 'Ausgewählter Griff',
  every: 'Pixel von Punkt zu Punkt',
  points: (width, height) => `${number(width)} × ${number(height)} Punkte`,
  selected: (handle) => `Ausgewählt: ${handle}.`,
};
