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
  allOfIt: 'Erweitert',
  covered: 'Zugeschnitten',
  export: (format) => `${format} exportieren`,
  exportRig: 'Rig exportieren',
  exportMap: 'Karte exportieren',
  exportWeights: 'Gewichte exportieren',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Verlustfrei, mit Transparenz.',
    jpeg: 'Kleine Dateien für Fotos, ohne Transparenz.',
    webp: 'Kleine Dateien, mit Transparenz.',
    svg: 'Die Zeichnung mit gebogenen Pfaden. Sie bleibt in jeder Größe scharf.',
  },
  areaNotes: {
    picture: 'Der Rahmen des Originals.',
    grown: 'Erweitert um Teile, die über den Rahmen hinaus gebogen sind.',
    covered: 'Auf den sichtbaren Teil zugeschnitten, ohne leeren Rand.',
  },
  remark: (detail) => `Hinweis: ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Ein Film braucht einen Clip. Legen Sie in der Zeitleiste einen an.',
  openTimeline: 'Zeitleiste öffnen',
  clip: 'Clip',
  frames: 'PNGs',
  sheet: 'Sprites',
  formatNotes: {
    webm: 'Kleine Dateien mit weicher Transparenz, für Webseiten.',
    mp4: 'Kleine Dateien ohne Transparenz. Läuft fast überall.',
    gif: 'Läuft überall, hat aber nur 255 Farben und harte Kanten.',
    apng: 'Verlustfrei, mit weicher Transparenz.',
    webp: 'Verlustfrei und kleiner als APNG.',
    frames: 'Ein Zip mit einem PNG pro Einzelbild.',
    sheet:
      'Ein Zip mit einem Sprite-Sheet: alle Einzelbilder in einem PNG und eine JSON-Datei für Spiele-Engines.',
  },
  codec: (name) => `Codec: ${name}.`,
  codecWithEvenSides: (name, width, height) =>
    `Codec: ${name}. Breite und Höhe werden auf gerade Zahlen aufgerundet: ${width} × ${height} px.`,
  gifRate: (most) => `GIFs haben höchstens ${most} Bilder pro Sekunde, mehr spielen die Betrachter nicht ab.`,
  noCodec: (formats) => `Dieser Browser kann ${list(formats)} nicht kodieren.`,
  rate: 'Bildrate',
  rateTip: 'Bilder pro Sekunde',
  allFrames: 'Erweitert',
  part: 'Abschnitt',
  wholeClip: 'Ganzer Clip',
  aPart: 'Abschnitt',
  from: 'Von',
  to: 'Bis',
  transparent: 'Transparent',
  colour: 'Farbe',
  softEdgesOn: 'Matte-Farbe',
  frameCount: (count) => counted(count, 'Einzelbild', 'Einzelbilder'),
  estimate: (size, time) => `etwa ${size}, ${time}`,
  aFewSeconds: 'ein paar Sekunden',
  aFewSecondsLeft: 'noch ein paar Sekunden',
  left: (time) => `noch etwa ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: 'Eine kleine Datei mit allen Clips. Ein Player-Skript von 15 kB zeigt sie ohne den Editor.',
  withoutClips: 'Ohne Clip zeigt die Seite die aktuelle Pose.',
  readers: 'Besucher können',
  watch: 'Clips ansehen',
  pose: 'Griffe bewegen',
  solver: 'Dadurch wird die Datei etwa 100 kB größer, und die Seite lädt weitere 100 kB.',
  code: 'Code',
  copyCode: 'Code kopieren',
  codeNote:
    'Fügen Sie den Code in eine Seite ein. Legen Sie die Datei und den Ordner „player“ des Pakets daneben.',
  codeCopied: (file) => `Kopiert. Legen Sie ${file} und den Ordner „player“ des Pakets neben die Seite.`,
  codeNotCopied: 'Der Browser hat die Zwischenablage gesperrt. Kopieren Sie den markierten Code selbst.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Für Spine 4.2 und seine Laufzeitumgebungen: JSON, Atlas und PNG.',
    dragonbones: 'Für DragonBones 5.5 und seine Laufzeitumgebungen: zwei JSON-Dateien und ein PNG.',
    gltf: 'glTF 2.0 für three.js, Blender und andere, in einer Datei.',
    godot: 'Eine Szene für Godot 4 mit ihrem PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Enthält Netz, Knochen und Pose. Mit einem Clip kommt eine Animation dazu.'
      : plural(count, {
          one: 'Enthält den Clip als Animation.',
          other: `Enthält ${count} Clips als Animationen.`,
        }),
  rough:
    'Knochen bilden die Griffe nur annähernd ab, darum weicht das Rig leicht ab. Der Export nennt die Abweichung.',
  bones: 'Knochen',
  bonesTip: 'Höchste Zahl der Knochen, ohne die Wurzel',
  vertices: 'Eckpunkte',
  verticesTip: 'Höchste Zahl der Eckpunkte des Netzes',
  influences: 'Knochen pro Eckpunkt',
  files: 'Dateien',
  zip: 'Zip',
  folder: 'Ordner',
  lossCaption: (bones, sites, vertices) =>
    `Letztes Rig: Knochen ${bones}, Griffe und Hilfspunkte ${sites}, Eckpunkte ${vertices}. Abweichung in Pixeln:`,
  largest: 'Größte',
  pose: 'Pose',
  randomPoses: 'Zufallsposen',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Zwischen Eckpunkten',
  loss: (percentile, largest) =>
    `99 % der Eckpunkte weichen höchstens ${percentile} px ab. Die größte Abweichung ist ${largest} px.`,
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
    inverse: 'Eine ST-Map für Compositing-Programme. Sie biegt andere Bilder genauso wie dieses.',
    forward: 'Eine ST-Map, die auf dem gebogenen Bild die Biegung rückgängig macht.',
    stretch: 'Wie stark Flächen und Längen an jedem Pixel des gebogenen Bilds wachsen.',
    disocclusion: 'Rot, wo die Biegung einen Bereich aufdeckt, grün, wo sie einen verdeckt.',
    heat: 'Wie stark das Bild einem Griff folgt, in Farben über dem Original.',
    weights: 'Wie stark Punkte des Originals jedem Griff folgen, als Zahlen für Skripte.',
  },
  formatNotes: {
    exr: 'OpenEXR mit 32-Bit-Gleitkommazahlen. Der Dateikopf beschreibt die Kanäle.',
    png: '16 Bit pro Kanal, für Programme ohne OpenEXR.',
  },
  csvNote: 'Eine Zeile für jedes Gewicht über 0.',
  npyNote: 'Ein NumPy-Array.',
  npyZipNote: 'Ein Zip mit einem NumPy-Array und der Liste seiner Griffe und Hilfspunkte.',
  of: 'Gewichte von',
  allSites: 'Alle Griffe',
  selectedHandle: 'Ausgewählter Griff',
  every: 'Abstand in Pixeln',
  points: (width, height) => `${number(width)} × ${number(height)} Punkte`,
  selected: (handle) => `Ausgewählt: ${handle}.`,
};
