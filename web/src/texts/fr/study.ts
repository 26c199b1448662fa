/**
 * The card that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper, which are
 * shown with an index.
 */
import type { Texts } from '../texts';
import { counted, plural } from './language';

export const study: Texts['study'] = {
  title: 'Voir l’article',
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
  title: 'Les poids d’un point',
  point: 'Pointez sur l’image',
  nothingBends: 'Rien ne se déforme ici',
  note: 'Chaque point se déplace selon les poids des poignées qui l’entourent. Les flèches déplacent aussi la loupe.',
  tap: 'Touchez un point pour l’examiner',
  click: 'Cliquez pour garder ce point',
  follow: 'Suivre le pointeur',
  weights: 'Poids',
  weightsAt: (x, y) => `Les poids en x ${x}, y ${y}`,
  noHandle: 'Il n’y a pas de poignée sur cette partie : elle reste en place.',
  ownWeight: 'poids propre',
  passedOn: 'transmis par des poignées virtuelles',
  virtualHandles: 'Poignées virtuelles',
  countOfThem: (count) => `au nombre de ${count}`,
  virtual: (number) => `Virtuelle ${number}`,
  distancePassed: (distance, percent) => `${distance}, ${percent} transmis`,
  spoken: (x, y, shares) => `x ${x}, y ${y} : ${shares.join(', ') || 'aucune poignée ne le déplace'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `poignées virtuelles ${percent}`,

  falloff: 'Décroissance',
  falloffOf: (handle) => `Décroissance : ${handle}`,
  noEnd: 'Il n’y a pas d’autre poignée sur cette partie : son support n’a pas de fin.',
  falloffLabel: (value, distance, end) =>
    `La décroissance vaut ${value} à la distance de ${distance}, et s’achève à ${end}.`,
  radii: (cell, nearest, support) =>
    `Cellule r_d ${cell}${nearest === null ? '' : `, autre la plus proche r_h ${nearest}`}${support === null ? '' : `, support r ${support}`}. Faites glisser r dans la figure, ou α.`,
  distanceAxis: 'distance d dans la forme, px',
  thisPoint: (distance) => `ce point : ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Les cellules et leurs rayons',
  none: 'Sans poignée, il n’y a pas de cellules.',
  counts: (own, virtual) => `${counted(own, 'cellule')} de poignées, ${virtual} de poignées virtuelles`,
  label: 'La forme avec ses cellules et leurs rayons',
  farthest: 'r_d, jusqu’au point le plus éloigné de la cellule',
  nearest: 'r_h, jusqu’à l’autre poignée la plus proche',
  note: 'Un support couvre sa cellule et s’achève avant la prochaine de vos poignées. r_d doit donc rester dans la limite de r_h.',
  toFarthest: 'jusqu’au point le plus éloigné de la cellule',
  toNearest: 'jusqu’à l’autre site le plus proche',
  times: 'Durées de ce calcul',
  stages: {
    domain: 'Recherche du contour',
    sampling: 'Échantillonnage',
    regions: 'Distances, cellules et poignées virtuelles',
    weights: 'Poids',
    pose: 'Une pose',
  },
};

/** Algorithm 1 of the paper, round by round. */
export const rounds: Texts['rounds'] = {
  title: 'Algorithme 1',
  figure: (round) => `Tour ${round} de l’algorithme 1`,
  none: 'Sans poignée, il n’y a rien à insérer.',
  play: 'Lire',
  pause: 'Pause',
  previous: 'Tour précédent',
  next: 'Tour suivant',
  round: 'Tour',
  roundOf: (round, rounds) => `Tour ${round} sur ${rounds}`,
  end: (round, handles) =>
    `Tour ${round} : la fin. Aucune cellule n’est trop grande, et il y a ${counted(handles, 'poignée')}.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Tour ${round} : une cellule s’étend à ${reach}, et ${allowed} sont permis. ${enters}`,
  asked: (round, enters) =>
    `Tour ${round} : aucune cellule n’est trop grande, mais le projet demande plus de poignées virtuelles. ${enters}`,
  enters: (handle, distance, others) =>
    `Une poignée virtuelle entre dans cette cellule : ${handle}, à une distance de ${distance}${others > 0 ? `, et ${plural(others, { one: `${others} autre`, other: `${others} autres` })} ailleurs` : ''}.`,
  curve: (score, allowed) => `Le score est de ${score}. Il peut être d’au plus ${allowed}.`,
  note: 'Le score de la pire cellule avant chaque tour, comme dans la figure 3 de l’article. Sous la ligne, chaque support couvre sa cellule et s’achève avant la poignée suivante. Les tours d’après insèrent les poignées virtuelles que le projet demande.',
  roundAxis: 'tour',
  allowed: 'permis',
};

export const compare: Texts['compare'] = {
  title: 'Une image par trois méthodes',
  note: 'Faites glisser les poignées de l’image. Les trois suivent.',
  names: { paper: 'Article', rigid: 'Rigide', plain: 'Distance simple' },
  labels: {
    paper: 'L’image selon l’article',
    rigid: 'L’image en rigide',
    plain: 'L’image par distance simple',
  },
  notes: {
    paper: 'Distances dans la forme et champs harmoniques. Vous tournez les poignées vous-même.',
    rigid: 'La forme se préserve autant que possible. Les poignées tournent d’elles-mêmes.',
    plain: 'Comme l’article, mais les distances franchissent les vides : les parties proches suivent aussi.',
  },
};

/** All settings, each with a sentence on its effect. */
export const settings: Texts['settings'] = {
  motion: 'Mouvement des poignées virtuelles',
  motionNotes: {
    rigid:
      'Elles préservent la forme de l’image : les membres plient, et les poignées tournent d’elles-mêmes.',
    harmonic:
      'Des champs harmoniques mélangent les mouvements de vos poignées, comme dans l’article (éq. 4). Vous tournez les poignées.',
  },
  rigid: 'Rigide',
  byHand: 'Manuel',
  density: 'Poignées virtuelles',
  densityNote:
    'Plus il y en a, plus l’image se déforme finement et moins un glissement porte loin. Avec 0, l’algorithme de l’article décide.',
  atLeast: 'Au moins',
  shapeFactor: 'Facteur de support α',
  shapeFactorNote:
    'La portée de chaque poignée. À 0, elle dépasse à peine sa propre cellule, et les courbures sont serrées. À 1, elle va aussi loin que permis, et les courbures sont douces.',
  support: 'Règle des supports',
  supportNotes: {
    smooth: 'Les supports des poignées virtuelles se recouvrent. L’image se déforme régulièrement.',
    paper:
      'Les supports s’achèvent à la poignée suivante, virtuelles comprises (éq. 3). L’image se déforme par plus petits pas.',
  },
  smooth: 'Lisse',
  paper: 'Article',
  continuity: 'Continuité',
  continuityNotes: {
    c2: 'Les courbures sont lisses aussi derrière les coins et autour des trous : deux dérivées continues. Les trous reçoivent des poignées virtuelles.',
    exact:
      'L’image peut montrer un pli fin derrière un trou, là où deux chemins qui le contournent sont de même longueur.',
  },
  exact: 'Exacte',
  degree: 'Degré n de la décroissance',
  degreeNote:
    'À 5, la courbure entre deux poignées est courte, et les parties proches d’elles bougent d’un bloc. Un degré plus élevé la répartit sur le trajet.',
  filling: 'Remplissage de la décroissance',
  fillingNote:
    'Le parcours de la décroissance entre ses extrémités, à partir du degré 7. « Ligne » descend régulièrement. « Moitié » garde un palier, où les parties suivent deux poignées par moitié.',
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
  samples: 'Échantillons',
  samplesNote:
    'Les points qui portent l’image. Plus il y en a, plus les courbures sont fines et plus le calcul est long.',
  points: 'Points',
  threshold: 'Opacité minimale',
  thresholdNote:
    'Ce qui est plus transparent ne se déforme pas. Une valeur plus basse entraîne les bords doux et les cheveux fins.',
  opacity: 'Opacité',
  asInPaper: 'Comme dans l’article',
  asInEditor: 'Comme dans l’éditeur',
};
