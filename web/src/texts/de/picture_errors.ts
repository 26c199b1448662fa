import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'Die Datei ist leer.',
  unreadable:
    'Die Datei kann nicht gelesen werden: Sie ist ein Ordner, oder sie wurde verschoben oder geändert. Die Datei erneut auswählen.',
  incomplete: 'Das Bild ist unvollständig: Das Ende der Datei fehlt. Die Datei erneut beschaffen.',
  unknown: 'Die Datei ist kein Bild, das dieser Browser lesen kann. PNG, JPEG oder WebP verwenden.',
  otherKind: (kind) => `Dies ist ${kind}. Als PNG, JPEG oder WebP speichern.`,
  kinds: {
    png: 'ein PNG-Bild',
    jpeg: 'ein JPEG-Bild',
    gif: 'ein GIF-Bild',
    webp: 'ein WebP-Bild',
    avif: 'ein AVIF-Bild',
    heic: 'ein HEIC-Bild',
    bmp: 'ein BMP-Bild',
    icon: 'ein Symbol',
    tiff: 'ein TIFF-Bild',
    photoshop: 'ein Photoshop-Dokument',
    pdf: 'ein PDF-Dokument',
    postscript: 'ein PostScript-Dokument',
    jpegXl: 'ein JPEG-XL-Bild',
    jpeg2000: 'ein JPEG-2000-Bild',
    svg: 'eine SVG-Zeichnung',
    compressed: 'eine komprimierte Datei',
  },
  damaged:
    'Das Bild ist beschädigt, oder dieser Browser kann es nicht lesen. Es erneut als PNG, JPEG oder WebP speichern.',
  tooSmall: (width, height, least) =>
    `Das Bild hat ${width} × ${height} px. Es muss mindestens ${least} × ${least} px haben.`,
  tooLong: (width, height, most) =>
    `Das Bild hat ${width} × ${height} px. Eine Seite darf höchstens ${number(most)} px haben: das Bild verkleinern.`,
  tooLarge: (width, height, millions) =>
    `Das Bild hat ${width} × ${height} px. Es darf höchstens ${millions} Millionen Pixel haben: das Bild verkleinern.`,
  drawingDamaged: 'Die Zeichnung ist beschädigt, oder dieser Browser kann sie nicht zeigen.',
  drawingWithoutSize: 'Die Zeichnung hat keine Größe. Ihr eine Breite und Höhe oder eine viewBox geben.',
  drawingTooLarge: 'Die Zeichnung hat mehr als 64 MB. Sie vereinfachen.',
  drawingEncoding: (encoding) =>
    `Die Zeichnung kann nicht als ${encoding} gelesen werden. Als UTF-8 speichern.`,
  drawingUnread: 'Die Zeichnung konnte nicht gelesen werden. Die Verbindung prüfen und sie erneut öffnen.',
  drawingTooManyElements: (most) => `Die Zeichnung hat mehr als ${number(most)} Elemente. Sie vereinfachen.`,
  drawingTooManyAttributes: (most) =>
    `Ein Element der Zeichnung hat mehr als ${most} Attribute. Einige entfernen.`,
  drawingTooDeep: (most) =>
    `Elemente der Zeichnung sind mehr als ${most} Ebenen tief verschachtelt. Gruppen auflösen.`,
  drawingTooManyCopies:
    'Elemente der Zeichnung werden zu oft verwendet. Kleinere oder weniger davon verwenden.',
  drawingTooManyStyles: 'Die Stile der Zeichnung brauchen zu lange. Sie vereinfachen.',
  drawingTooSlow: (element) =>
    `Die Zeichnung braucht zu lange zum Zeichnen, vor allem ihre <${element}>. Sie vereinfachen.`,
  drawingTooMuchMemory: (element) =>
    `Die Zeichnung braucht zu viel Speicher zum Zeichnen, vor allem ihre <${element}>. Sie vereinfachen.`,
  noWebgl:
    'Dieser Browser kann Bilder nicht mit WebGL2 lesen. Hardwarebeschleunigung einschalten oder einen anderen Browser verwenden.',
  contextLost: 'Der Grafikkontext ging verloren, während das Bild gelesen wurde. Das Bild erneut öffnen.',
};

export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `${file} konnte nicht geladen werden: Der Server antwortete mit ${status}.`,
  webPage: (file) =>
    `${file} konnte nicht geladen werden: Es ist eine Webseite. Die Adresse des Bilds selbst angeben.`,
  unreachable: (file) => `${file} konnte nicht geladen werden. Die Adresse und die Netzverbindung prüfen.`,
  refused: (file, host) =>
    `${file} konnte nicht geladen werden. ${host} lässt diese Seite nicht lesen (CORS) oder ist nicht erreichbar. Das Bild speichern und die Datei öffnen.`,
  damaged: 'Das Bild in der Adresse ist beschädigt. Es erneut kopieren oder als Datei speichern.',
};

export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'Das Projekt in diesem Bild ist zu lang.',
  damaged: 'Das Projekt in diesem Bild ist beschädigt.',
  compressed: 'Das Projekt in diesem Bild ist komprimiert, was nicht unterstützt wird.',
};
