import type { Texts } from '../texts';
import { plural } from './language';

export const study: Texts['study'] = {
  title: 'Zum Artikel',
  page: 'Seite',
  pages: {
    lens: 'Lupe',
    cells: 'Zellen',
    rounds: 'Runden',
    compare: 'Vergleich',
    settings: 'Optionen',
  },
  close: 'Schließen',
  saveAsSvg: 'Als SVG speichern',
};

export const lens: Texts['lens'] = {
  title: 'Die Gewichte eines Punkts',
  point: 'Auf das Bild zeigen',
  nothingBends: 'Hier biegt sich nichts',
  note: 'Jeder Punkt bewegt sich nach den Gewichten der Griffe ringsum. Auch Pfeiltasten bewegen die Lupe.',
  tap: 'Auf einen Punkt tippen, um ihn anzusehen',
  click: 'Klicken, um diesen Punkt zu behalten',
  follow: 'Dem Zeiger folgen',
  weights: 'Gewichte',
  weightsAt: (x, y) => `Die Gewichte bei x ${x}, y ${y}`,
  noHandle: 'Auf diesem Teil ist kein Griff, darum bleibt er.',
  ownWeight: 'eigenes Gewicht',
  passedOn: 'von virtuellen Griffen weitergegeben',
  virtualHandles: 'Virtuelle Griffe',
  countOfThem: (count) => `${count} davon`,
  virtual: (number) => `Virtuell ${number}`,
  distancePassed: (distance, percent) => `${distance}, ${percent} weitergegeben`,
  spoken: (x, y, shares) => `x ${x}, y ${y}: ${shares.join(', ') || 'kein Griff bewegt ihn'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `virtuelle Griffe ${percent}`,

  falloff: 'Abfall',
  falloffOf: (handle) => `Abfall: ${handle}`,
  noEnd: 'Auf diesem Teil ist kein anderer Griff, darum hat der Träger kein Ende.',
  falloffLabel: (value, distance, end) =>
    `Der Abfall ist ${value} im Abstand von ${distance} und endet bei ${end}.`,
  radii: (cell, nearest, support) =>
    `Zelle r_d ${cell}${nearest === null ? '' : `, nächster anderer r_h ${nearest}`}${support === null ? '' : `, Träger r ${support}`}. In der Abbildung r ziehen, oder α.`,
  distanceAxis: 'Abstand d innerhalb der Form, px',
  thisPoint: (distance) => `dieser Punkt: ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Zellen mit ihren Radien',
  none: 'Ohne Griff gibt es keine Zellen.',
  counts: (own, virtual) => `Zellen von Griffen: ${own}, von virtuellen Griffen: ${virtual}`,
  label: 'Die Form mit ihren Zellen und deren Radien',
  farthest: 'r_d, zum fernsten Punkt der Zelle',
  nearest: 'r_h, zum nächsten anderen Griff',
  note: 'Ein Träger deckt seine Zelle und endet vor dem nächsten eigenen Griff. Darum muss r_d innerhalb der Grenze von r_h bleiben.',
  toFarthest: 'zum fernsten Punkt der Zelle',
  toNearest: 'zur nächsten anderen Stützstelle',
  times: 'Zeiten dieser Lösung',
  stages: {
    domain: 'Umriss finden',
    sampling: 'Abtasten',
    regions: 'Abstände, Zellen und virtuelle Griffe',
    weights: 'Gewichte',
    pose: 'Eine Pose',
  },
};

export const rounds: Texts['rounds'] = {
  title: 'Algorithmus 1',
  figure: (round) => `Runde ${round} von Algorithmus 1`,
  none: 'Ohne Griff gibt es nichts einzufügen.',
  play: 'Abspielen',
  pause: 'Pause',
  previous: 'Vorige Runde',
  next: 'Nächste Runde',
  round: 'Runde',
  roundOf: (round, rounds) => `Runde ${round} von ${rounds}`,
  end: (round, handles) =>
    `Runde ${round}: das Ende. Keine Zelle ist zu groß, und es gibt ${plural(handles, { one: 'einen Griff', other: `${handles} Griffe` })}.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Runde ${round}: Eine Zelle reicht ${reach} weit, erlaubt sind ${allowed}. ${enters}`,
  asked: (round, enters) =>
    `Runde ${round}: Keine Zelle ist zu groß, aber das Projekt verlangt mehr virtuelle Griffe. ${enters}`,
  enters: (handle, distance, others) =>
    `In einer Zelle (${handle}) kommt ein virtueller Griff hinzu, ${distance} entfernt${others > 0 ? `, und anderswo ${plural(others, { one: 'ein weiterer', other: `${others} weitere` })}` : ''}.`,
  curve: (score, allowed) => `Die Wertung ist ${score}. Sie darf höchstens ${allowed} sein.`,
  note: 'Die Wertung der schlechtesten Zelle vor jeder Runde, wie in Abbildung 3 des Artikels. Unter der Linie deckt jeder Träger seine Zelle und endet vor dem nächsten Griff. Spätere Runden fügen die virtuellen Griffe ein, die das Projekt verlangt.',
  roundAxis: 'Runde',
  allowed: 'erlaubt',
};

export const compare: Texts['compare'] = {
  title: 'Ein Bild nach drei Verfahren',
  note: 'An den Griffen des Bilds ziehen. Alle drei folgen.',
  names: { paper: 'Artikel', rigid: 'Starr', plain: 'Luftlinie' },
  labels: {
    paper: 'Das Bild nach dem Artikel',
    rigid: 'Das Bild, starr gebogen',
    plain: 'Das Bild nach der Luftlinie',
  },
  notes: {
    paper: 'Abstände innerhalb der Form und harmonische Felder. Griffe werden von Hand gedreht.',
    rigid: 'Die Form bleibt so weit wie möglich erhalten. Griffe drehen sich von selbst.',
    plain: 'Wie der Artikel, aber Abstände queren die Lücken, darum gehen nahe Teile mit.',
  },
};

export const settings: Texts['settings'] = {
  motion: 'Bewegung virtueller Griffe',
  motionNotes: {
    rigid: 'Sie erhalten die Form des Bilds: Glieder biegen sich, und Griffe drehen sich von selbst.',
    harmonic:
      'Harmonische Felder mischen die Bewegungen der eigenen Griffe, wie im Artikel (Gl. 4). Griffe werden von Hand gedreht.',
  },
  rigid: 'Starr',
  byHand: 'Von Hand',
  density: 'Virtuelle Griffe',
  densityNote:
    'Mehr davon biegen das Bild feiner, und ein Ziehen reicht weniger weit. Bei 0 entscheidet der Algorithmus des Artikels.',
  atLeast: 'Mindestens',
  shapeFactor: 'Trägerfaktor α',
  shapeFactorNote:
    'Wie weit jeder Griff reicht. Bei 0 reicht er kaum über die eigene Zelle hinaus, und Biegungen sind eng. Bei 1 reicht er so weit, wie er darf, und Biegungen sind weich.',
  support: 'Regel der Träger',
  supportNotes: {
    smooth: 'Träger virtueller Griffe überlappen sich. Das Bild biegt sich gleichmäßig.',
    paper:
      'Träger enden am nächsten Griff, auch an virtuellen (Gl. 3). Das Bild biegt sich in kleineren Schritten.',
  },
  smooth: 'Weich',
  paper: 'Artikel',
  continuity: 'Stetigkeit',
  continuityNotes: {
    c2: 'Biegungen sind auch hinter Ecken und um Löcher glatt: zwei stetige Ableitungen. Löcher bekommen virtuelle Griffe.',
    exact: 'Das Bild kann hinter einem Loch eine feine Falte zeigen, wo zwei Wege darum gleich lang sind.',
  },
  exact: 'Exakt',
  degree: 'Grad n des Abfalls',
  degreeNote:
    'Bei 5 ist die Biegung zwischen zwei Griffen kurz, und Teile nahe an ihnen bewegen sich wie aus einem Stück. Ein höherer Grad verteilt sie über den Weg.',
  filling: 'Füllung des Abfalls',
  fillingNote:
    'Wie der Abfall zwischen seinen Enden verläuft, ab Grad 7. „Linie“ fällt gleichmäßig. „Hälfte“ behält eine Stufe, auf der Teile zwei Griffen je zur Hälfte folgen.',
  line: 'Linie',
  half: 'Hälfte',
  blend: 'Mischung',
  blendNotes: {
    rigid:
      'Drehungen mischen sich zu Drehungen: Ein Teil zwischen zwei gegenläufigen Drehungen behält seine Größe.',
    linear:
      'Bewegungen werden gemittelt, wie im Artikel (Gl. 1): Ein Teil zwischen zwei gegenläufigen Drehungen schrumpft.',
  },
  linear: 'Linear',
  samples: 'Abtastpunkte',
  samplesNote:
    'Die Punkte, die das Bild tragen. Mehr davon zeichnen Biegungen feiner, und das Lösen dauert länger.',
  points: 'Punkte',
  threshold: 'Mindestdeckkraft',
  thresholdNote:
    'Alles, was durchsichtiger ist, biegt sich nicht. Eine kleinere Zahl nimmt weiche Kanten und dünnes Haar mit.',
  opacity: 'Deckkraft',
  asInPaper: 'Wie im Artikel',
  asInEditor: 'Wie im Editor',
};
