import type { Texts } from '../texts';
import { counted, plural } from './language';

export const study: Texts['study'] = {
  title: 'So funktioniert die Biegung',
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
  title: 'Gewichte an einem Punkt',
  point: 'Auf das Bild zeigen',
  nothingBends: 'Hier biegt sich nichts',
  note: 'Jeder Punkt folgt den Griffen ringsum nach ihren Gewichten. Sie können die Lupe auch mit den Pfeiltasten bewegen.',
  tap: 'Auf einen Punkt tippen, um ihn anzusehen',
  click: 'Klicken, um diesen Punkt festzuhalten',
  follow: 'Dem Zeiger folgen',
  weights: 'Gewichte',
  weightsAt: (x, y) => `Die Gewichte bei x ${x}, y ${y}`,
  noHandle: 'Dieser Teil hat keinen Griff, darum bleibt er stehen.',
  ownWeight: 'direktes Gewicht',
  passedOn: 'indirektes Gewicht, über Hilfspunkte',
  virtualHandles: 'Hilfspunkte',
  countOfThem: (count) => counted(count, 'Punkt', 'Punkte'),
  virtual: (number) => `Hilfspunkt ${number}`,
  distancePassed: (distance, percent) => `${distance}, ${percent} indirekt`,
  spoken: (x, y, shares) => `x ${x}, y ${y}: ${shares.join(', ') || 'kein Griff bewegt ihn'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `Hilfspunkte ${percent}`,

  falloff: 'Abfall',
  falloffOf: (handle) => `Abfall: ${handle}`,
  noEnd: 'Dies ist der einzige Griff auf seinem Teil, darum hat sein Träger kein Ende.',
  falloffLabel: (value, distance, end) =>
    `Der Abfall beträgt ${value} im Abstand von ${distance} und endet bei ${end}.`,
  radii: (cell, nearest, support) =>
    `Zellradius r_d ${cell}${nearest === null ? '' : `, nächster Nachbar r_h ${nearest}`}${support === null ? '' : `, Träger r ${support}`}. Ziehen Sie r in der Abbildung, oder stellen Sie α ein.`,
  distanceAxis: 'Abstand d innerhalb der Form, px',
  thisPoint: (distance) => `dieser Punkt: ${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'Zellen und ihre Radien',
  none: 'Fügen Sie einen Griff hinzu, um seine Zelle zu sehen.',
  counts: (own, virtual) => `Zellen: ${own} von Griffen, ${virtual} von Hilfspunkten`,
  label: 'Die Form mit ihren Zellen und deren Radien',
  farthest: 'r_d, zum fernsten Punkt der Zelle',
  nearest: 'r_h, zum nächsten Nachbarn',
  note: 'Ein Träger deckt seine Zelle ab und endet vor Ihrem nächsten Griff. Darum begrenzt r_h den Radius r_d. Im Artikel heißen Hilfspunkte „virtual handles“.',
  toFarthest: 'zum fernsten Punkt der Zelle',
  toNearest: 'zum nächsten Nachbarn',
  times: 'Rechenzeit nach Schritten',
  stages: {
    domain: 'Umriss finden',
    sampling: 'Netz aufbauen',
    regions: 'Abstände, Zellen und Hilfspunkte',
    weights: 'Gewichte',
    pose: 'Pose',
  },
};

export const rounds: Texts['rounds'] = {
  title: 'Algorithmus 1',
  figure: (round) => `Runde ${round} von Algorithmus 1`,
  none: 'Fügen Sie einen Griff hinzu, um den Algorithmus laufen zu lassen.',
  play: 'Abspielen',
  pause: 'Pause',
  previous: 'Vorige Runde',
  next: 'Nächste Runde',
  round: 'Runde',
  roundOf: (round, rounds) => `Runde ${round} von ${rounds}`,
  end: (round, handles) =>
    `Runde ${round}: fertig. Keine Zelle ist zu groß. Griffe und Hilfspunkte insgesamt: ${handles}.`,
  tooLarge: (round, reach, allowed, enters) =>
    `Runde ${round}: Eine Zelle reicht ${reach} weit und überschreitet die Grenze von ${allowed}. ${enters}`,
  asked: (round, enters) =>
    `Runde ${round}: Keine Zelle ist zu groß, aber das Projekt verlangt mehr Hilfspunkte. ${enters}`,
  enters: (handle, distance, others) =>
    `In einer Zelle (${handle}) kommt ein Hilfspunkt hinzu, ${distance} entfernt${others > 0 ? `, und anderswo ${plural(others, { one: 'ein weiterer', other: `${others} weitere` })}` : ''}.`,
  curve: (score, allowed) => `Die Wertung ist ${score}. Die Grenze ist ${allowed}.`,
  note: 'Die Wertung der schlechtesten Zelle vor jeder Runde, wie in Abbildung 3 des Artikels. Unter der Linie deckt jeder Träger seine Zelle ab und endet vor dem nächsten Griff. Spätere Runden fügen die Hilfspunkte ein, die das Projekt verlangt.',
  roundAxis: 'Runde',
  allowed: 'Grenze',
};

export const compare: Texts['compare'] = {
  title: 'Ein Bild, drei Verfahren',
  note: 'Ziehen Sie an den Griffen des Bilds. Alle drei folgen.',
  names: { paper: 'Artikel', rigid: 'Starr', plain: 'Luftlinie' },
  labels: {
    paper: 'Das Bild, gebogen wie im Artikel',
    rigid: 'Das Bild, starr gebogen',
    plain: 'Das Bild, gebogen nach Luftlinie',
  },
  notes: {
    paper: 'Abstände innerhalb der Form und harmonische Felder. Sie drehen die Griffe selbst.',
    rigid: 'Teile behalten ihre Form so weit wie möglich. Griffe drehen sich automatisch.',
    plain: 'Wie im Artikel, aber Abstände überspringen Lücken, darum bewegen sich nahe Teile mit.',
  },
};

export const settings: Texts['settings'] = {
  motion: 'Bewegung der Hilfspunkte',
  motionNotes: {
    rigid: 'Sie erhalten die Form des Bilds: Glieder biegen sich, und Griffe drehen sich automatisch.',
    harmonic:
      'Harmonische Felder mischen die Bewegungen Ihrer Griffe, wie im Artikel (Gl. 4). Sie drehen die Griffe selbst.',
  },
  rigid: 'Starr',
  byHand: 'Elastisch',
  density: 'Hilfspunkte',
  densityNote:
    'Mehr Punkte biegen das Bild feiner, und jede Bewegung reicht weniger weit. Bei 0 entscheidet der Algorithmus des Artikels.',
  atLeast: 'Mindestens',
  shapeFactor: 'Trägerfaktor α',
  shapeFactorNote:
    'Wie weit jeder Griff reicht. Bei 0 reicht er kaum über die eigene Zelle hinaus, und Biegungen sind eng. Bei 1 reicht er so weit wie möglich, und Biegungen sind weich.',
  support: 'Trägerregel',
  supportNotes: {
    smooth: 'Träger von Hilfspunkten überlappen sich, darum biegt sich das Bild gleichmäßig.',
    paper:
      'Träger enden am nächsten Griff oder Hilfspunkt (Gl. 3), darum biegt sich das Bild in kleineren Schritten.',
  },
  smooth: 'Weich',
  paper: 'Artikel',
  continuity: 'Stetigkeit',
  continuityNotes: {
    c2: 'Biegungen sind auch hinter Ecken und um Löcher glatt: Zwei Ableitungen sind stetig. Löcher bekommen Hilfspunkte.',
    exact: 'Hinter einem Loch kann ein feiner Knick entstehen, wo zwei Wege darum gleich lang sind.',
  },
  exact: 'Exakt',
  degree: 'Grad n des Abfalls',
  degreeNote:
    'Bei 5 ist die Biegung zwischen zwei Griffen kurz, und das Bild nahe an jedem Griff bewegt sich als Ganzes. Ein höherer Grad verteilt die Biegung.',
  filling: 'Form des Abfalls',
  fillingNote:
    'Der Verlauf des Abfalls zwischen seinen Enden, ab Grad 7. „Linie“ fällt gleichmäßig. „Hälfte“ hat eine Stufe, auf der das Bild zwei Griffen gleich stark folgt.',
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
  samples: 'Netzpunkte',
  samplesNote:
    'Die Ecken des Netzes, das das Bild trägt. Mehr Punkte zeichnen Biegungen feiner, aber die Berechnung dauert länger.',
  points: 'Punkte',
  threshold: 'Mindestdeckkraft',
  thresholdNote:
    'Pixel, die durchsichtiger sind, biegen sich nicht. Eine kleinere Zahl schließt weiche Kanten und dünnes Haar ein.',
  opacity: 'Deckkraft',
  asInPaper: 'Standard des Artikels',
  asInEditor: 'Standard des Editors',
};
