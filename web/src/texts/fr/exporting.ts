/** The export panel. */
import type { Texts } from '../texts';
import { counted, list, number, plural } from './language';

export const exporting: Texts['exporting'] = {
  kind: 'Type',
  kinds: { picture: 'Image', film: 'Film', page: 'Page web', engine: 'Moteur', maps: 'Cartes' },
  format: 'Format',
  size: 'Taille',
  quality: 'Qualité',
  background: 'Fond',
  area: 'Zone',
  original: 'Original',
  allOfIt: 'Agrandie',
  covered: 'Rognée',
  export: (format) => `Exporter ${format}`,
  exportRig: 'Exporter le rig',
  exportMap: 'Exporter la carte',
  exportWeights: 'Exporter les poids',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Sans perte, avec transparence.',
    jpeg: 'De petits fichiers pour les photos, sans transparence.',
    webp: 'De petits fichiers, avec transparence.',
    svg: 'Le dessin aux tracés déformés. Il reste net à toute taille.',
  },
  areaNotes: {
    picture: 'Le cadre de l’image originale.',
    grown: 'Agrandie pour inclure les parties déformées hors du cadre original.',
    covered: 'Rognée à la partie visible, sans bord vide.',
  },
  remark: (detail) => `Remarque : ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Un film a besoin d’un clip. Ajoutez-en un dans la chronologie.',
  openTimeline: 'Ouvrir la chronologie',
  clip: 'Clip',
  frames: 'PNG',
  sheet: 'Planche',
  formatNotes: {
    webm: 'De petits fichiers avec une transparence douce, pour les pages web.',
    mp4: 'De petits fichiers sans transparence. Lisible presque partout.',
    gif: 'Lisible partout, mais limité à 255 couleurs et à des bords durs.',
    apng: 'Sans perte, avec une transparence douce.',
    webp: 'Sans perte, et plus léger qu’un APNG.',
    frames: 'Un zip avec un PNG par image.',
    sheet:
      'Un zip avec une planche de sprites : toutes les images dans un PNG, et un fichier JSON pour les moteurs de jeu.',
  },
  codec: (name) => `Codec : ${name}.`,
  codecWithEvenSides: (name, width, height) =>
    `Codec : ${name}. La largeur et la hauteur sont arrondies à des nombres pairs : ${width} × ${height} px.`,
  gifRate: (most) =>
    `Les GIF sont limités à ${most} images par seconde, le maximum que les lecteurs affichent.`,
  noCodec: (formats) => `Ce navigateur ne peut pas encoder ${list(formats)}.`,
  rate: 'Cadence',
  rateTip: 'Images par seconde',
  allFrames: 'Agrandie',
  part: 'Extrait',
  wholeClip: 'Clip entier',
  aPart: 'Un extrait',
  from: 'De',
  to: 'À',
  transparent: 'Transparent',
  colour: 'Couleur',
  softEdgesOn: 'Couleur de détourage',
  frameCount: (count) => counted(count, 'image'),
  estimate: (size, time) => `environ ${size}, ${time}`,
  aFewSeconds: 'quelques secondes',
  aFewSecondsLeft: 'encore quelques secondes',
  left: (time) => `encore ${time} environ`,
};

export const webPage: Texts['webPage'] = {
  note: 'Un petit fichier avec tous les clips. Un script de lecture de 15 ko l’affiche sans l’éditeur.',
  withoutClips: 'Sans clip, la page montre la pose actuelle.',
  readers: 'Les visiteurs peuvent',
  watch: 'Voir les clips',
  pose: 'Placer les poignées',
  solver: 'Cela ajoute environ 100 ko au fichier et 100 ko à la page.',
  code: 'Code',
  copyCode: 'Copier le code',
  codeNote:
    'Collez ce code dans une page. Placez à côté d’elle le fichier et le dossier « player » du paquet.',
  codeCopied: (file) => `Copié. Placez ${file} et le dossier « player » du paquet à côté de la page.`,
  codeNotCopied: 'Le navigateur a bloqué le presse-papiers. Copiez vous-même le code sélectionné.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Pour Spine 4.2 et ses moteurs : JSON, atlas et PNG.',
    dragonbones: 'Pour DragonBones 5.5 et ses moteurs : deux fichiers JSON et un PNG.',
    gltf: 'glTF 2.0 pour three.js, Blender et d’autres, en un seul fichier.',
    godot: 'Une scène de Godot 4 avec son PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Contient le maillage, les os et la pose. Ajoutez un clip pour inclure une animation.'
      : plural(count, {
          one: 'Inclut le clip comme animation.',
          other: `Inclut ${count} clips comme animations.`,
        }),
  rough:
    'Les os ne reproduisent les poignées qu’approximativement : le rig s’écarte un peu. L’export indique de combien.',
  bones: 'Os',
  bonesTip: 'Nombre maximal d’os, sans compter la racine',
  vertices: 'Sommets',
  verticesTip: 'Nombre maximal de sommets du maillage',
  influences: 'Os par sommet',
  files: 'Fichiers',
  zip: 'Zip',
  folder: 'Dossier',
  lossCaption: (bones, sites, vertices) =>
    `Le dernier rig utilise ${number(bones)} os pour ${number(sites)} poignées et points auxiliaires, et ${counted(vertices, 'sommet')}. Erreur en pixels :`,
  largest: 'Maximum',
  pose: 'Pose',
  randomPoses: 'Poses aléatoires',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Entre les sommets',
  loss: (percentile, largest) =>
    `99 % des sommets s’écartent d’au plus ${percentile} px. La plus grande erreur est de ${largest} px.`,
};

export const maps: Texts['maps'] = {
  map: 'Carte',
  names: {
    inverse: 'Inverse',
    forward: 'Directe',
    stretch: 'Étirement',
    disocclusion: 'Désocclusion',
    heat: 'Thermique',
    weights: 'Poids',
  },
  notes: {
    inverse: 'Une carte ST pour le compositing. Elle applique cette déformation à d’autres images.',
    forward: 'Une carte ST qui annule la déformation quand on l’applique à l’image déformée.',
    stretch: 'L’agrandissement des aires et des longueurs à chaque pixel de l’image déformée.',
    disocclusion: 'Rouge là où la déformation découvre une zone, vert là où elle en recouvre une.',
    heat: 'À quel point l’image suit une poignée, en couleurs sur l’original.',
    weights: 'À quel point les points de l’original suivent chaque poignée, en nombres pour des scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR en flottants de 32 bits. L’en-tête décrit les canaux.',
    png: '16 bits par canal, pour les programmes sans OpenEXR.',
  },
  csvNote: 'Une ligne pour chaque poids supérieur à 0.',
  npyNote: 'Un tableau NumPy.',
  npyZipNote: 'Un zip avec un tableau NumPy et la liste de ses poignées et points auxiliaires.',
  of: 'Poids de',
  allSites: 'Toutes les poignées',
  selectedHandle: 'Poignée sélectionnée',
  every: 'Espacement en pixels',
  points: (width, height) => `${number(width)} × ${number(height)} points`,
  selected: (handle) => `Sélection : ${handle}.`,
};
