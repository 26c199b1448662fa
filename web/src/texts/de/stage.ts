import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Pfeiltasten verschieben die Auswahl. Komma und Punkt drehen sie, und mit Alt skalieren sie sie.',
  noPicture: 'Kein Bild',
  picture: (name) => `Bild ${name}`,
  disabled: (picture) => `${picture}, deaktiviert`,
  posable: (picture) => `${picture}, mit Griffen zum Bewegen`,
  original: 'Original',
  opening: 'Wird geöffnet …',
  drop: 'Ein Bild hier ablegen, eines einfügen oder',
  openPicture: 'Ein Bild öffnen',
  required: 'Ein Bild öffnen.',
  wouldFold: 'würde sich hier falten',
  dismiss: 'Schließen',
  handles: 'Griffe',
  selectionCorners: 'Ecken der Auswahl',
  selectionCorner: (corner, part, x, y) =>
    `Ecke ${corner} von ${part === null ? 'der Auswahl' : `Teil ${part} der Auswahl`}, x ${x}, y ${y}`,
  selectionCornerKeys: 'Pfeiltasten verschieben sie. Entf löscht sie, und C fügt danach eine hinzu.',
  pictureMenu: 'Bild',
  cornerMenu: (corner, handle) => `Ecke ${corner} von ${handle}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Einen Stab ziehen oder seine Ecken klicken',
    tap: 'Einen Stab ziehen oder seine Ecken tippen',
  },
  polygon: {
    click: 'Ein Polygon zeichnen: seine Ecken klicken',
    tap: 'Ein Polygon zeichnen: seine Ecken tippen',
  },
  lasso: {
    click: 'Den Teil umfahren, der sich biegt: ziehen oder Ecken klicken',
    tap: 'Den Teil umfahren, der sich biegt: ziehen oder Ecken tippen',
  },
  lassoAgain: 'Eine Ecke der Auswahl ziehen oder einen anderen Teil umfahren',
  select: {
    click: 'Das Punktwerkzeug nehmen und auf das Bild klicken',
    tap: 'Das Punktwerkzeug nehmen und auf das Bild tippen',
  },
  point: {
    click: 'Auf das Bild klicken, wo es gehalten werden soll',
    tap: 'Auf das Bild tippen, wo es gehalten werden soll',
  },
  snapToEdges: 'An Kanten einrasten',
  snapToEdgesTip: 'Das Lasso folgt Kanten des Bilds. Alt halten, um frei zu zeichnen',
};

export const drawing: Texts['drawing'] = {
  label: 'Zeichnung',
  ready: 'Ecken hinzufügen oder fertigstellen',
  oneMore: 'Noch eine Ecke',
  more: (count) => `Noch ${count} Ecken`,
  takeBack: 'Letzte Ecke zurücknehmen',
  giveUp: 'Zeichnung verwerfen',
  finish: 'Fertig',
};

export const brush: Texts['brush'] = {
  label: 'Pinsel',
  effect: 'Wirkung des Pinsels',
  kinds: {
    push: 'Schieben',
    pinch: 'Stauchen',
    bloat: 'Aufblähen',
    smooth: 'Glätten',
    restore: 'Aufheben',
    stiffen: 'Versteifen',
  },
  tips: {
    push: 'Schieben: das Bild mitziehen',
    pinch: 'Stauchen: das Bild zusammenziehen',
    bloat: 'Aufblähen: das Bild ausdehnen',
    smooth: 'Glätten: Stellen ausgleichen, die der Pinsel bewegt hat',
    restore: 'Aufheben: Pinselstriche zurücknehmen',
    stiffen: 'Versteifen: die Form von Stellen erhalten',
  },
  hints: {
    push: 'Ziehen, um das Bild mitzuschieben.',
    pinch: 'Drücken oder ziehen, um das Bild zusammenzuziehen.',
    bloat: 'Drücken oder ziehen, um das Bild auszudehnen.',
    smooth: 'Ziehen, um Stellen auszugleichen, die der Pinsel bewegt hat.',
    restore: 'Ziehen, um Pinselstriche zurückzunehmen.',
    stiffen: 'Über Stellen ziehen, die ihre Form behalten sollen.',
  },
  altHints: {
    push: 'Alt hebt es auf.',
    pinch: 'Alt bläht auf.',
    bloat: 'Alt staucht.',
    smooth: '',
    restore: 'Alt schiebt.',
    stiffen: 'Alt radiert.',
  },
  size: 'Größe',
  strength: 'Stärke',
  sizeLabel: 'Pinselgröße (%)',
  strengthLabel: 'Pinselstärke (%)',
  erase: 'Radieren',
  eraseTip: 'Steifigkeit radieren',
  clearStiffness: 'Steifigkeit löschen',
  clearStiffnessTip: 'Das Bild wieder weich machen',
  clearStrokes: 'Pinselstriche löschen',
  clearStrokesTip: 'Alles zurücknehmen, was der Pinsel bewegt hat',
  holding: 'Pfeile schieben, Eingabe lässt los.',
  rigidOnly: 'Steifigkeit zählt nur beim starren Biegen.',
  bendRigidly: 'Starr biegen',
};

export const status: Texts['status'] = {
  label: 'Status',
  hasCreases: 'Das Bild hat Falten',
  privacy: 'Nichts verlässt den Browser',
  privacyTip: 'Bilder werden nur auf diesem Gerät geöffnet, verbogen und gespeichert.',
  view: 'Ansicht',
  zoom: 'Zoom',
  seeIt: 'Ansehen',
  out: 'Kleiner',
  in: 'Größer',
  fit: 'Einpassen',
  actual: '1 : 1',
  stoppedAtFold: 'An einer Falte angehalten',
  creases: (count) => counted(count, 'Falte', 'Falten'),
  creasesAnd: (creases, effect) => `${creases}. ${effect}`,
  hideCreases: 'Falten ausblenden',
  showCreases: 'Falten zeigen',
  zoomToCrease: 'Zur Falte zoomen',
  zoomToNextCrease: 'Zur nächsten Falte zoomen',
  cancel: 'Abbrechen',
  samples: (count) => counted(count, 'Abtastpunkt', 'Abtastpunkte'),
  virtualHandles: (count) => counted(count, 'virtueller Griff', 'virtuelle Griffe'),
};

export const tasks: Texts['tasks'] = {
  opening: (name) => `Öffnen: ${name}`,
  start: 'Umriss finden',
  domain: 'Abtasten',
  sampling: 'Abstände messen',
  regions: 'Gewichten',
  weights: 'Gewichten',
  suggesting: 'Stellen für Griffe suchen',
  filling: 'Hintergrund füllen',
  exporting: 'Exportieren',
};
