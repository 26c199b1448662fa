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
  allOfIt: 'Le tout',
  covered: 'Couverte',
  export: (format) => `Exporter ${format}`,
  exportRig: 'Exporter le rig',
  exportMap: 'Exporter la carte',
  exportWeights: 'Exporter les poids',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Chaque pixel tel quel, avec transparence.',
    jpeg: 'De petits fichiers pour les photos, sans transparence.',
    webp: 'De petits fichiers, avec transparence.',
    svg: 'Le dessin aux tracés déformés, nets à toute taille.',
  },
  areaNotes: {
    picture: 'Le rectangle de l’original.',
    grown: 'Agrandie pour contenir les parties déformées hors de l’original.',
    covered: 'Seulement la partie couverte, sans bord vide.',
  },
  remark: (detail) => `Remarque : ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Il n’y a pas encore de clip : un film en montre un.',
  openTimeline: 'Ouvrir la chronologie',
  clip: 'Clip',
  frames: 'PNG',
  sheet: 'Planche',
  formatNotes: {
    webm: 'Léger, avec une transparence douce. Pour les pages web.',
    mp4: 'Léger, sans transparence. Lisible presque partout.',
    gif: 'Lisible partout. 255 couleurs, bords durs.',
    apng: 'Chaque pixel tel quel, avec une transparence douce.',
    webp: 'Chaque pixel tel quel, plus léger qu’un APNG.',
    frames: 'Un zip avec un PNG par image.',
    sheet: 'Un zip de toutes les images dans un PNG, avec un fichier JSON pour les moteurs de jeu.',
  },
  codec: (name) => `Avec ${name}.`,
  codecWithEvenSides: (name, width, height) =>
    `Avec ${name}. Ses côtés sont pairs : ${width} × ${height} px.`,
  gifRate: (most) => `Un GIF reçoit ${most} images par seconde, le maximum que les lecteurs affichent.`,
  noCodec: (formats) => `${list(formats)} : ce navigateur ne l’encode pas.`,
  rate: 'Cadence',
  rateTip: 'Images par seconde',
  allFrames: 'Toutes les images',
  part: 'Extrait',
  wholeClip: 'Clip entier',
  aPart: 'Un extrait',
  from: 'De',
  to: 'À',
  transparent: 'Transparent',
  colour: 'Couleur',
  softEdgesOn: 'Bords doux sur',
  frameCount: (count) => counted(count, 'image'),
  estimate: (size, time) => `environ ${size}, ${time}`,
  aFewSeconds: 'quelques secondes',
  aFewSecondsLeft: 'encore quelques secondes',
  left: (time) => `encore ${time} environ`,
};

export const webPage: Texts['webPage'] = {
  note: 'Un petit fichier avec tous les clips, pour le lecteur : un script de 13 ko qui se passe de l’éditeur.',
  withoutClips: 'Il n’y a pas encore de clip : la page montre la pose.',
  readers: 'Lecteurs',
  watch: 'Voir les clips',
  pose: 'Placer les poignées',
  solver: 'La page charge alors 100 ko de plus, et le fichier grossit d’environ autant.',
  code: 'Code',
  copyCode: 'Copier le code',
  codeNote: 'Collez-le dans une page à côté du fichier et du dossier « player » du paquet.',
  codeCopied: (file) =>
    `Copié. Le code montre ${file} dans une page placée à côté de ce fichier et du dossier « player » du paquet.`,
  codeNotCopied: 'Le navigateur a bloqué le presse-papiers. Le code est sélectionné : copiez-le à la main.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Spine 4.2 et ses moteurs : JSON, atlas et PNG.',
    dragonbones: 'DragonBones 5.5 et ses moteurs : deux fichiers JSON et un PNG.',
    gltf: 'glTF 2.0 pour three.js, Blender et d’autres : un seul fichier.',
    godot: 'Une scène de Godot 4 avec son PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Maillage, os et pose. Il n’y a pas encore de clip.'
      : plural(count, {
          one: 'Avec le clip comme animation.',
          other: `Avec ${count} clips comme animations.`,
        }),
  rough:
    'Les os se mélangent plus simplement que les poignées : un rig s’écarte donc un peu. L’export indique de combien.',
  bones: 'Os',
  bonesTip: 'Le nombre maximal d’os, outre la racine ; chaque poignée en a un',
  vertices: 'Sommets',
  verticesTip: 'Le nombre maximal de sommets du maillage',
  influences: 'Os par sommet',
  files: 'Fichiers',
  zip: 'Zip',
  folder: 'Dossier',
  lossCaption: (bones, sites, vertices) =>
    `Le dernier rig a ${number(bones)} os pour ${counted(sites, 'site')}, et ${counted(vertices, 'sommet')}. Son écart, en pixels :`,
  largest: 'Maximum',
  pose: 'Pose',
  randomPoses: 'Poses aléatoires',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Entre les sommets',
  loss: (percentile, largest) =>
    `99 % des sommets s’écartent d’au plus ${percentile} px, le pire de ${largest} px.`,
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
    inverse: 'Une carte ST pour le compositing : elle déforme d’autres images comme celle-ci.',
    forward: 'Le chemin inverse : comme carte ST sur l’image déformée, elle défait la déformation.',
    stretch: 'L’agrandissement des aires et des longueurs, à chaque pixel de l’image déformée.',
    disocclusion: 'Rouge là où la déformation découvre quelque chose, vert là où elle en recouvre.',
    heat: 'À quel point l’image suit une poignée, en couleurs sur l’original.',
    weights: 'À quel point les points de l’original suivent, en nombres pour des scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR en flottants de 32 bits. L’en-tête explique les canaux.',
    png: '16 bits par canal, pour les programmes sans OpenEXR.',
  },
  csvNote: 'Une ligne pour chaque poids supérieur à 0.',
  npyNote: 'Un tableau pour NumPy.',
  npyZipNote: 'Un zip : un tableau pour NumPy et la liste de ses sites.',
  of: 'De',
  allSites: 'Tous les sites',
  selectedHandle: 'Poignée sélectionnée',
  every: 'Pixels d’un point à l’autre',
  points: (width, height) => `${number(width)} × ${number(height)} points`,
  selected: (handle) => `Sélection : ${handle}.`,
};
