import type { Texts } from '../texts';
import { counted } from './language';

export const stage: Texts['stage'] = {
  keys: 'Pfeiltasten verschieben die Auswahl. Komma und Punkt drehen sie oder skalieren sie mit Alt.',
  noPicture: 'Kein Bild',
  picture: (name) => `Bild ${name}`,
  disabled: (picture) => `${picture}, deaktiviert`,
  posable: (picture) => `${picture}, mit Griffen zum Bewegen`,
  original: 'Original',
  opening: 'Wird geöffnet …',
  drop: 'Ein Bild hier ablegen, eines einfügen oder',
  openPicture: 'Ein Bild öffnen',
  required: 'Öffnen Sie ein Bild.',
  wouldFold: 'würde sich hier falten',
  dismiss: 'Schließen',
  handles: 'Griffe',
  selectionCorners: 'Ecken der Auswahl',
  selectionCorner: (corner, part, x, y) =>
    `Ecke ${corner} von ${part === null ? 'der Auswahl' : `Teil ${part} der Auswahl`}, x ${x}, y ${y}`,
  selectionCornerKeys:
    'Pfeiltasten verschieben die Ecke. Entf löscht sie, und C fügt danach eine weitere hinzu.',
  pictureMenu: 'Bild',
  cornerMenu: (corner, handle) => `Ecke ${corner} von ${handle}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'Einen Stab durch Ziehen zeichnen oder seine Ecken klicken',
    tap: 'Einen Stab durch Ziehen zeichnen oder seine Ecken tippen',
  },
  polygon: {
    click: 'Die Ecken des Polygons klicken',
    tap: 'Die Ecken des Polygons tippen',
  },
  lasso: {
    click: 'Den Teil umfahren, der sich biegen soll: ziehen oder Ecken klicken',
    tap: 'Den Teil umfahren, der sich biegen soll: ziehen oder Ecken tippen',
  },
  lassoAgain: 'Eine Ecke der Auswahl ziehen oder einen anderen Teil umfahren',
  select: {
    click: 'Das Punktwerkzeug wählen und auf das Bild klicken',
    tap: 'Das Punktwerkzeug wählen und auf das Bild tippen',
  },
  point: {
    click: 'Auf das Bild klicken, wo ein Griff sitzen soll',
    tap: 'Auf das Bild tippen, wo ein Griff sitzen soll',
  },
  snapToEdges: 'An Kanten einrasten',
  snapToEdgesTip: 'Das Lasso folgt Kanten im Bild. Halten Sie Alt, um frei zu zeichnen',
};

export const drawing: Texts['drawing'] = {
  label: 'Zeichnung',
  ready: 'Ecken hinzufügen oder fertigstellen',
  oneMore: 'Noch eine Ecke',
  more: (count) => `Noch ${count} Ecken`,
  takeBack: 'Letzte Ecke entfernen',
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
    restore: 'Entfernen',
    stiffen: 'Versteifen',
  },
  tips: {
    push: 'Schieben: das Bild mitziehen',
    pinch: 'Stauchen: das Bild zusammenziehen',
    bloat: 'Aufblähen: das Bild nach außen schieben',
    smooth: 'Glätten: Pinselstriche ausgleichen',
    restore: 'Entfernen: Pinselstriche rückgängig machen',
    stiffen: 'Versteifen: Bereiche starr halten',
  },
  hints: {
    push: 'Ziehen, um das Bild mitzuziehen.',
    pinch: 'Drücken oder ziehen, um das Bild zusammenzuziehen.',
    bloat: 'Drücken oder ziehen, um das Bild nach außen zu schieben.',
    smooth: 'Ziehen, um Pinselstriche auszugleichen.',
    restore: 'Ziehen, um Pinselstriche zu entfernen.',
    stiffen: 'Über Bereiche ziehen, die starr bleiben sollen.',
  },
  altHints: {
    push: 'Alt entfernt Striche.',
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
  clearStiffnessTip: 'Das ganze Bild wieder weich machen',
  clearStrokes: 'Pinselstriche löschen',
  clearStrokesTip: 'Alle Pinselstriche aus dem Bild entfernen',
  holding: 'Pfeiltasten schieben, Eingabe lässt los.',
  rigidOnly: 'Steifigkeit wirkt nur im starren Modus.',
  bendRigidly: 'Starren Modus verwenden',
};

export const status: Texts['status'] = {
  label: 'Status',
  hasCreases: 'Das Bild hat Falten',
  privacy: 'Nichts verlässt den Browser',
  privacyTip: 'Bilder werden nur auf diesem Gerät geöffnet, gebogen und gespeichert.',
  view: 'Ansicht',
  zoom: 'Zoom',
  seeIt: 'Vorschau',
  out: 'Kleiner',
  in: 'Größer',
  fit: 'Einpassen',
  actual: '1 : 1',
  stoppedAtFold: 'An einer Falte angehalten',
  creases: (count) => counted(count, 'Falte', 'Falten'),
  creasesAnd: (creases, effect) => `${creases}. ${effect}`,
  hideCreases: 'Falten ausblenden',
  showCreases: 'Falten anzeigen',
  zoomToCrease: 'Zur Falte zoomen',
  zoomToNextCrease: 'Zur nächsten Falte zoomen',
  cancel: 'Abbrechen',
  samples: (count) => counted(count, 'Netzpunkt', 'Netzpunkte'),
  virtualHandles: (count) => counted(count, 'Hilfspunkt', 'Hilfspunkte'),
};

export const tasks: Texts['tasks'] = {
  opening: (name) => `Öffnen: ${name}`,
  start: 'Umriss finden',
  domain: 'Netz aufbauen',
  sampling: 'Abstände messen',
  regions: 'Gewichte berechnen',
  weights: 'Gewichte berechnen',
  suggesting: 'Stellen für Griffe suchen',
  filling: 'Hintergrund füllen',
  exporting: 'Exportieren',
};
