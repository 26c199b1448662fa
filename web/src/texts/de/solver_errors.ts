import type { Texts } from '../texts';
import { quoted } from './language';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: 'Das Bild ist zu groß für den Arbeitsspeicher. Verkleinern Sie es.',
  pictures: 'Die Bilder sind zu groß für den Arbeitsspeicher. Verkleinern Sie sie.',
  suggest: 'Der Speicher reicht nicht, um Griffe vorzuschlagen. Verkleinern Sie das Bild.',
  solve:
    'Der Speicher reicht für diese Biegung nicht aus. Verwenden Sie weniger Griffe oder eine gröbere Feinheit.',
  fill: 'Der Speicher reicht nicht, um den Hintergrund zu füllen. Verkleinern Sie das Bild.',
  draw: 'Der Speicher reicht nicht, um das Bild zu zeichnen. Wählen Sie eine kleinere Größe.',
  film: 'Der Speicher dieses Browsers reicht nicht für den Film. Wählen Sie eine kleinere Größe.',
  points: 'Der Speicher reicht nicht für so viele Punkte.',
  cells: 'Der Speicher dieses Browsers reicht nicht, um die Zellen zu berechnen.',
  study: 'Der Speicher dieses Browsers reicht nicht, um die Abbildungen zu berechnen.',
  lens: 'Der Speicher dieses Browsers reicht nicht für die Lupe.',
  rig: 'Die Clips sind in diesem Browser zu lang für ein Rig. Kürzen Sie sie.',
  map: 'Die Datei ist zu groß für diesen Browser. Verwenden Sie die Kommandozeile.',
  drawing: 'Die Zeichnung ist zu komplex für diesen Browser. Vereinfachen Sie sie.',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `Der Rechenkern konnte nicht geladen werden: ${why}`,
  exportNotLoaded: (why) => `Der Export konnte nicht gestartet werden: ${why}`,
  status: (address, status) => `Der Server antwortete mit ${status} auf ${address}.`,
  isPage: (address) => `Der Server schickte eine Webseite statt ${address}.`,
  absent: (address) =>
    `${address} ist nicht erreichbar. Prüfen Sie die Verbindung und die Sicherheitsrichtlinie der Seite.`,
  incomplete: (address, detail) => `${address} ist unvollständig oder kann hier nicht laufen (${detail}).`,
  noWorkers:
    'Der Rechenkern konnte nicht gestartet werden: Dieser Browser oder diese Seite erlaubt keine Worker.',
  notStarted: (address) =>
    `Der Rechenkern konnte nicht gestartet werden. Prüfen Sie, ob ${address} existiert und die Seite Worker erlaubt.`,
  exportNotStarted: (address) =>
    `Der Export konnte nicht gestartet werden. Prüfen Sie, ob ${address} existiert und die Seite Worker erlaubt.`,
  drawingNotChecked:
    'Für diese Zeichnung fehlt ein Teil des Editors. Prüfen Sie die Verbindung und ob die Seite Worker erlaubt.',
  lostDrawing: 'Der Rechenkern ist beim Zeichnen ausgefallen.',
  released: 'Die Pixel des Bilds sind nicht mehr im Speicher. Öffnen Sie das Bild erneut.',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `Das Projekt ist ungültig: ${detail}`,
  picture: (detail) => `Das Bild ist zu klein oder zu groß: ${detail}`,
  'picture-mismatch': () => 'Das Projekt ist für ein Bild von anderer Größe.',
  scale: () => 'Der Export wäre zu groß oder zu klein. Wählen Sie eine andere Größe.',
  canvas: () =>
    'Das erweiterte Bild wäre zu groß. Wählen Sie eine kleinere Größe oder den Rahmen des Originals.',
  'nothing-drawn': () => 'Das Bild ist überall durchsichtig.',
  'nothing-opaque': () =>
    'Kein Teil des Bilds ist deckend genug zum Biegen. Senken Sie die Einstellung „Mindestdeckkraft“.',
  'nothing-to-fill-from': () =>
    'Um die Auswahl bleibt nichts übrig, um den Hintergrund zu füllen. Zeichnen Sie eine kleinere, oder schalten Sie die Füllung aus.',
  'no-outline': () =>
    'Das Bild hat keine durchsichtigen Teile und damit keinen Umriss, an den ein Rig angepasst werden kann.',
  domain: (detail) => `Die Auswahl ist ungültig: ${detail}`,
  'handle-outside': (_, name) =>
    `${quoted(name)} liegt außerhalb der Form. Setzen Sie den Griff auf das Bild.`,
  'handle-far-outside': (_, name) => `Dieses Rig passt nicht zum Bild: ${quoted(name)} läge weit außerhalb.`,
  'handles-too-close': (_, name, other) =>
    `${quoted(name)} und ${quoted(other)} liegen an derselben Stelle. Verschieben oder löschen Sie einen der Griffe.`,
  'bar-too-short': (_, name) =>
    `${quoted(name)} hat zwei Ecken an derselben Stelle. Verschieben oder löschen Sie eine davon.`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `${quoted(name)} läuft auf sich selbst zurück. Die Stücke dürfen sich kreuzen oder berühren, aber nicht aufeinanderliegen.`
      : `${quoted(name)} und ${quoted(other)} laufen aneinander entlang. Sie dürfen sich kreuzen oder berühren, aber nicht aufeinanderliegen.`,
  'on-held-boundary': (_, name) =>
    `${quoted(name)} liegt auf dem fixierten Umriss. Verschieben Sie den Griff nach innen, oder lösen Sie den Umriss.`,
  'too-many-handles': () => 'Das sind zu viele Griffe. Löschen Sie einige.',
  'too-many-corners': (_, name) =>
    name === ''
      ? 'Stäbe und Polygone haben zu viele Ecken. Zeichnen Sie sie mit weniger Ecken.'
      : `Stäbe und Polygone haben zu viele Ecken. Zeichnen Sie ${quoted(name)} mit weniger Ecken.`,
  'handles-crowded': () =>
    'Zu viele Griffe liegen sehr nah beieinander. Rücken Sie einige auseinander, oder löschen Sie welche.',
  'outline-too-long': () =>
    'Dieser Umriss hat zu viele Schlitze und Spitzen. Zeichnen Sie einen einfacheren oder gröberen.',
  'too-many-sites': () =>
    'Die Griffe sind zu viele oder liegen zu nah beieinander. Rücken Sie einige auseinander, oder wählen Sie eine gröbere Feinheit.',
  'too-much-memory': () =>
    'Diese Biegung braucht zu viel Speicher für einen Browser. Verwenden Sie weniger Griffe oder eine gröbere Feinheit.',
  'too-much-work': () =>
    'Diese Biegung ist zu komplex, um sie in wenigen Sekunden zu berechnen. Verwenden Sie weniger Griffe oder einen einfacheren Umriss.',
  'held-too-fine': () =>
    'Dieser Umriss hat zu viele Ecken zum Fixieren. Zeichnen Sie einen einfacheren, oder lösen Sie den Umriss.',
  unsupported: (detail) => `Eine Einstellung des Projekts wird nicht unterstützt: ${detail}`,
  pose: (detail) => `Die Pose ist ungültig: ${detail}`,
  film: (detail) => `Der Film ist nicht möglich: ${detail}`,
  'point-outside': (detail) => `Ein Punkt liegt außerhalb: ${detail}`,
  mesh: (detail) => `Das Netz ist ungültig: ${detail}`,
  cloud: (detail) => `Die Punkte sind ungültig: ${detail}`,
  poser: (detail) => `Die Pose kann nicht berechnet werden: ${detail}`,
};
