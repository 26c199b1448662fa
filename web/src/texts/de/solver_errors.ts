import type { Texts } from '../texts';
import { quoted } from './language';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'Das Bild braucht mehr Speicher, als da ist: es verkleinern.',
  pictures: 'Die Bilder brauchen mehr Speicher, als da ist: sie verkleinern.',
  suggest: 'Um Griffe vorzuschlagen, braucht das Bild mehr Speicher, als da ist: es verkleinern.',
  solve: 'Das ist mehr, als der Löser mit dem vorhandenen Speicher kann.',
  fill: 'Um den Hintergrund zu füllen, braucht das Bild mehr Speicher, als da ist: es verkleinern.',
  draw: 'Zum Zeichnen braucht das Bild mehr Speicher, als da ist.',
  film: 'Zum Zeichnen braucht der Film mehr Speicher, als dieser Browser gibt.',
  points: 'Die Punkte brauchen mehr Speicher, als da ist.',
  cells: 'Die Zellen sind mehr, als der Löser in diesem Browser kann.',
  study: 'Die Abbildungen sind mehr, als der Löser in diesem Browser kann.',
  lens: 'Die Lupe ist mehr, als der Löser in diesem Browser kann.',
  rig: 'Die Clips sind mehr, als ein Rig in diesem Browser fassen kann: sie kürzen.',
  map: 'Die Datei ist mehr, als dieser Browser fassen kann: Die Kommandozeile schreibt sie.',
  drawing: 'Die Zeichnung ist mehr, als dieser Browser biegen kann: sie vereinfachen.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `Der Löser konnte nicht geladen werden: ${why}`,
  exportNotLoaded: (why) => `Der Export konnte nicht gestartet werden: ${why}`,
  status: (address, status) => `${address} antwortet mit ${status}`,
  isPage: (address) => `${address} ist nicht da: An der Stelle ist eine Webseite`,
  absent: (address) => `${address} kommt nicht: Ist das Netz da, und erlaubt es die Seite?`,
  incomplete: (address, detail) => `${address} kam unvollständig an oder kann hier nicht laufen (${detail}).`,
  noWorkers: 'Der Löser konnte nicht gestartet werden: Dieser Browser oder diese Seite erlaubt keine Worker.',
  notStarted: (address) =>
    `Der Löser ist ausgefallen: Sein Worker konnte nicht gestartet werden: Ist ${address} da, und erlaubt es die Seite?`,
  exportNotStarted: (address) =>
    `Der Export konnte nicht gestartet werden: Ist ${address} da, und erlaubt die Seite Worker?`,
  lostDrawing: 'Der Löser ist während des Zeichnens ausgefallen.',
  released: 'Die Pixel des Bilds sind weg, oder es gibt keinen Speicher für sie. Das Bild erneut öffnen.',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `Das Projekt ist ungültig: ${detail}`,
  picture: (detail) => `Das Bild ist zu klein oder zu groß: ${detail}`,
  'picture-mismatch': () => 'Das Projekt ist für ein Bild von anderer Größe.',
  scale: () => 'Der Export wäre zu groß oder zu klein: eine andere Größe wählen.',
  canvas: () => 'Das ganze Bild wäre zu groß: eine kleinere Größe wählen oder das Rechteck des Originals.',
  'nothing-drawn': () => 'Nichts ist bedeckt: Das Bild ist überall durchsichtig.',
  'nothing-opaque': () =>
    'Nichts im Bild ist deckend genug, um gebogen zu werden: die Einstellung „Mindestdeckkraft“ senken.',
  'nothing-to-fill-from': () =>
    'Um die Auswahl ist nichts übrig, womit ihr Hintergrund gefüllt werden könnte: eine kleinere zeichnen oder ihn leer lassen.',
  'no-outline': () =>
    'Das Bild hat keinen durchsichtigen Teil und damit keinen Umriss, an den ein Rig angepasst werden könnte.',
  domain: (detail) => `Die Auswahl ist ungültig: ${detail}`,
  'handle-outside': (_, name) => `${quoted(name)} liegt außerhalb der Form: auf das Bild setzen.`,
  'handle-far-outside': (_, name) =>
    `${quoted(name)} läge weit außerhalb dieses Bilds: Das Rig passt nicht dazu.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} und ${quoted(other)} liegen an derselben Stelle: einen der Griffe verschieben oder löschen.`,
  'bar-too-short': (_, name) =>
    `${quoted(name)} hat zwei Ecken an derselben Stelle: eine davon verschieben oder löschen.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} läuft an sich selbst zurück: Die Stücke dürfen sich kreuzen und berühren, aber nicht aufeinanderliegen.`
      : `${quoted(name)} und ${quoted(other)} laufen aneinander entlang: Sie dürfen sich kreuzen und berühren, aber nicht aufeinanderliegen.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} steht auf dem Rand, der festgehalten wird: weiter nach innen verschieben oder den Rand freigeben.`,
  'too-many-handles': () => 'Es sind mehr Griffe, als der Löser unterstützt: einige löschen.',
  'too-many-corners': (_, name) =>
    name === ''
      ? 'Stäbe und Polygone haben mehr Ecken, als der Löser unterstützt: sie mit weniger Ecken zeichnen.'
      : `Stäbe und Polygone haben mehr Ecken, als der Löser unterstützt: ${quoted(name)} mit weniger Ecken zeichnen.`,
  'handles-crowded': () =>
    'Zu viele Griffe liegen sehr nah beieinander: einige auseinanderrücken oder löschen.',
  'outline-too-long': () =>
    'Dieser Umriss hat zu viele Schlitze und Spitzen: einen einfacheren oder gröberen zeichnen.',
  'too-many-sites': () =>
    'Die Griffe liegen zu nah beieinander, oder es sind zu viele: einige auseinanderrücken oder eine gröbere Feinheit wählen.',
  'too-much-memory': () =>
    'Das braucht mehr Speicher, als ein Browser hat: weniger Griffe verwenden oder eine gröbere Feinheit wählen.',
  'too-much-work': () =>
    'Das ist zu verwickelt, um es in wenigen Sekunden zu lösen: weniger Griffe verwenden oder einen einfacheren Umriss.',
  'held-too-fine': () =>
    'Dieser Umriss hat zu viele Ecken, um festgehalten zu werden: einen einfacheren zeichnen oder ihn sich bewegen lassen.',
  unsupported: (detail) => `Eine Einstellung des Projekts wird nicht unterstützt: ${detail}`,
  pose: (detail) => `Die Pose ist ungültig: ${detail}`,
  film: (detail) => `Der Film ist nicht möglich: ${detail}`,
  'point-outside': (detail) => `Ein Punkt liegt außerhalb: ${detail}`,
  mesh: (detail) => `Das Netz ist ungültig: ${detail}`,
  cloud: (detail) => `Die Punkte sind ungültig: ${detail}`,
  poser: (detail) => `Die Pose kann nicht berechnet werden: ${detail}`,
};
