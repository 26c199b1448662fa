/**
 * The panel that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
import type { Texts } from '../texts';
import { counted, plural } from './language';

export const study: Texts['study'] = {
  title: 'Comment fonctionne la déformation',
  page: 'Page',
  pages: {
    lens: 'Loupe',
    cells: 'Cellules',
    rounds: 'Tours',
    compare: 'Comparer',
    settings: 'Réglages',
  },
  close: 'Fermer',
  saveAsSvg: 'Enregistrer en SVG',
};

export const lens: Texts['lens'] = {
  title: 'Poids en un point',
  point: 'Pointez sur l’image',
  nothingBends: 'Rien ne se déforme ici',
  note: 'Chaque point suit les poignées qui l’entourent, selon leurs poids. Vous pouvez aussi déplacer la loupe avec les flèches.',
  tap: 'Touchez un point pour l’examiner',
  click: 'Cliquez pour fixer ce point',
  follow: 'Suivre le pointeur',
  weights: 'Poids',
  weightsAt: (x, y) => `Les poids en x ${x}, y ${y}`,
  noHandle: 'Cette partie n’a pas de poignée : elle reste en place.',
  ownWeight: 'poids direct',
  passedOn: 'poids indirect, par les points auxiliaires',
  virtualHandles: 'Points auxiliaires',
  countOfThem: (count) => counted(count, 'point'),
  virtual: (number) => `Auxiliaire ${number}`,
  distancePassed: (distance, percent) => `${distance}, ${percent} indirect`,
  spoken: (x, y, shares) => `x ${x}, y ${y} : ${shares.join(', ') || 'aucune poignée ne le déplace'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `points auxiliaires ${percent}`,

  falloff: 'Décroissance',
  falloffOf: (handle) => `Décroissance : ${handle}`,
  noEnd: 'C’est la seule poignée de sa partie : son support n’a pas de fin.',
  falloffLabel: (value, distance, end) =>
    `La décroissance vaut ${value} à une distance de ${distance}, et s’achève à ${end}.`,
  radii: (cell, nearest, support) =>
    `Rayon de la cellule r_d ${cell}${nearest === null ? '' : `, voisin le plus proche r_h ${nearest}`}${support === null ? '' : `, support r ${support}`}. Faites glisser r dans la figure, ou réglez α.`,
  distanceAxis: 'distance d dans la forme, px',
  thisPoint: (distance) => `ce point : ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Les cellules et leurs rayons',
  none: 'Ajoutez une poignée pour voir sa cellule.',
  counts: (own, virtual) => `Cellules : ${own} de poignées, ${virtual} de points auxiliaires`,
  label: 'La forme avec ses cellules et leurs rayons',
  farthest: 'r_d, jusqu’au point le plus éloigné de la cellule',
  nearest: 'r_h, jusqu’au voisin le plus proche',
  note: 'Un support couvre sa cellule et s’achève avant votre poignée suivante. r_h limite donc r_d. L’article appelle les points auxiliaires « virtual handles ».',
  toFarthest: 'jusqu’au point le plus éloigné de la cellule',
  toNearest: 'jusqu’au voisin le plus proche',
  times: 'Durée du calcul par étape',
  stages: {
    domain: 'Recherche du contour',
    sampling: 'Création du maillage',
    regions: 'Distances, cellules et points auxiliaires',
    weights: 'Poids',
    pose: 'Pose',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds: Texts['rounds'] = {
  title: 'Algorithme 1',
  figure: (round) => `Tour ${round} de l’algorithme 1`,
  none: 'Ajoutez une poignée pour lancer l’algorithme.',
  play: 'Lire',
  pause: 'Pause',
  previous: 'Tour précédent',
  next: 'Tour suivant',
  round: 'Tour',
  roundOf: (round, rounds) => `Tour ${round} sur ${rounds}`,
  end: (round, handles) =>
    `Tour ${round} : terminé. Aucune cellule n’est trop grande, avec ${handles} poignées et points auxiliaires en tout.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Tour ${round} : une cellule s’étend à ${reach}, au-delà de la limite de ${allowed}. ${enters}`,
  asked: (round, enters) =>
    `Tour ${round} : aucune cellule n’est trop grande, mais le projet demande plus de points auxiliaires. ${enters}`,
  enters: (handle, distance, others) =>
    `Un point auxiliaire entre dans cette cellule : ${handle}, à une distance de ${distance}${others > 0 ? `, et ${plural(others, { one: `${others} autre`, other: `${others} autres` })} ailleurs` : ''}.`,
  curve: (score, allowed) => `Le score est de ${score}. La limite est de ${allowed}.`,
  note: 'Le score de la pire cellule avant chaque tour, comme dans la figure 3 de l’article. Sous la ligne, chaque support couvre sa cellule et s’achève avant la poignée suivante. Les tours suivants ajoutent les points auxiliaires que le projet demande.',
  roundAxis: 'tour',
  allowed: 'limite',
};

export const compare: Texts['compare'] = {
  title: 'Une image, trois méthodes',
  note: 'Faites glisser les poignées de l’image. Les trois suivent.',
  names: { paper: 'Article', rigid: 'Rigide', plain: 'Distance simple' },
  labels: {
    paper: 'L’image déformée comme dans l’article',
    rigid: 'L’image déformée en mode rigide',
    plain: 'L’image déformée par distance simple',
  },
  notes: {
    paper: 'Distances dans la forme et champs harmoniques. Vous tournez les poignées vous-même.',
    rigid: 'Les parties gardent leur forme autant que possible. Les poignées tournent automatiquement.',
    plain:
      'Comme dans l’article, mais les distances franchissent les vides : les parties proches bougent aussi.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings: Texts['settings'] = {
  motion: 'Mouvement des points auxiliaires',
  motionNotes: {
    rigid: 'Ils gardent la forme de l’image : les membres plient, et les poignées tournent automatiquement.',
    harmonic:
      'Des champs harmoniques mélangent les mouvements de vos poignées, comme dans l’article (éq. 4). Vous tournez les poignées vous-même.',
  },
  rigid: 'Rigide',
  byHand: 'Élastique',
  density: 'Points auxiliaires',
  densityNote:
    'Plus il y a de points, plus l’image se déforme finement et moins un glissement porte loin. À 0, l’algorithme de l’article décide.',
  atLeast: 'Au moins',
  shapeFactor: 'Facteur de support α',
  shapeFactorNote:
    'La portée de chaque poignée. À 0, elle dépasse à peine sa propre cellule, et les courbures sont serrées. À 1, elle va aussi loin que possible, et les courbures sont douces.',
  support: 'Règle des supports',
  supportNotes: {
    smooth: 'Les supports des points auxiliaires se recouvrent : l’image se déforme régulièrement.',
    paper:
      'Les supports s’achèvent à la poignée ou au point auxiliaire suivant (éq. 3) : l’image se déforme par plus petits pas.',
  },
  smooth: 'Lisse',
  paper: 'Article',
  continuity: 'Continuité',
  continuityNotes: {
    c2: 'Les courbures sont lisses aussi derrière les coins et autour des trous : deux dérivées sont continues. Les trous reçoivent des points auxiliaires.',
    exact:
      'Une fine arête peut apparaître derrière un trou, là où deux chemins qui le contournent sont de même longueur.',
  },
  exact: 'Exacte',
  degree: 'Degré n de la décroissance',
  degreeNote:
    'À 5, la courbure entre deux poignées est courte, et l’image près de chacune bouge d’un bloc. Un degré plus élevé répartit la courbure.',
  filling: 'Forme de la décroissance',
  fillingNote:
    'Le parcours de la décroissance entre ses extrémités, à partir du degré 7. « Ligne » descend régulièrement. « Moitié » a un palier, où l’image suit deux poignées à parts égales.',
  line: 'Ligne',
  half: 'Moitié',
  blend: 'Mélange',
  blendNotes: {
    rigid:
      'Des rotations se mélangent en rotations : une partie entre deux rotations opposées garde sa taille.',
    linear:
      'Les mouvements sont moyennés, comme dans l’article (éq. 1) : une partie entre deux rotations opposées rétrécit.',
  },
  linear: 'Linéaire',
  samples: 'Points de maillage',
  samplesNote:
    'Les sommets du maillage qui porte l’image. Plus il y en a, plus les courbures sont fines, mais plus le calcul est long.',
  points: 'Points',
  threshold: 'Opacité minimale',
  thresholdNote:
    'Les pixels plus transparents ne se déforment pas. Une valeur plus basse inclut les bords doux et les cheveux fins.',
  opacity: 'Opacité',
  asInPaper: 'Valeurs de l’article',
  asInEditor: 'Valeurs de l’éditeur',
};
