import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'Die Datei ist leer.',
  unreadable:
    'Die Datei konnte nicht gelesen werden. Sie ist ein Ordner, oder sie wurde verschoben oder geändert. Wählen Sie sie erneut aus.',
  incomplete:
    'Das Bild ist unvollständig: Das Ende der Datei fehlt. Laden oder kopieren Sie die Datei erneut.',
  unknown: 'Dieser Browser kann die Datei nicht als Bild lesen. Verwenden Sie PNG, JPEG oder WebP.',
  otherKind: (kind) => `Das ist ${kind}. Speichern Sie das Bild als PNG, JPEG oder WebP.`,
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
    'Das Bild ist beschädigt, oder dieser Browser kann es nicht lesen. Speichern Sie es erneut als PNG, JPEG oder WebP.',
  tooSmall: (width, height, least) =>
    `Das Bild hat ${width} × ${height} px. Es muss mindestens ${least} × ${least} px haben.`,
  tooLong: (width, height, most) =>
    `Das Bild hat ${width} × ${height} px. Eine Seite darf höchstens ${number(most)} px haben. Verkleinern Sie das Bild.`,
  tooLarge: (width, height, millions) =>
    `Das Bild hat ${width} × ${height} px. Es darf höchstens ${millions} Millionen Pixel haben. Verkleinern Sie es.`,
  drawingDamaged: 'Die Zeichnung ist beschädigt, oder dieser Browser kann sie nicht anzeigen.',
  drawingWithoutSize:
    'Die Zeichnung hat keine Größe. Geben Sie ihr eine Breite und eine Höhe oder eine viewBox.',
  drawingTooLarge: 'Die Zeichnung ist größer als 64 MB. Vereinfachen Sie sie.',
  drawingEncoding: (encoding) =>
    `Die Zeichnung kann nicht als ${encoding} gelesen werden. Speichern Sie sie als UTF-8.`,
  drawingRefused: (detail) => `Die Zeichnung kann nicht geöffnet werden: ${detail}`,
  noWebgl:
    'Dieser Browser kann Bilder nicht mit WebGL2 lesen. Schalten Sie die Hardwarebeschleunigung ein, oder verwenden Sie einen anderen Browser.',
  contextLost:
    'Der Browser verlor beim Lesen des Bilds den Zugriff auf die Grafikkarte. Öffnen Sie das Bild erneut.',
};

export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `${file} konnte nicht geladen werden: Der Server antwortete mit ${status}.`,
  webPage: (file) => `${file} ist eine Webseite. Geben Sie die Adresse des Bilds selbst ein.`,
  unreachable: (file) => `${file} konnte nicht geladen werden. Prüfen Sie die Adresse und die Verbindung.`,
  refused: (file, host) =>
    `${file} konnte nicht geladen werden. ${host} gibt die Datei nicht für diese Seite frei (CORS) oder ist nicht erreichbar. Speichern Sie das Bild, und öffnen Sie dann die Datei.`,
  damaged: 'Das Bild in der Adresse ist beschädigt. Kopieren Sie es erneut, oder speichern Sie es als Datei.',
};

export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'Das Projekt in diesem Bild ist zu groß.',
  damaged: 'Das Projekt in diesem Bild ist beschädigt.',
  compressed: 'Das Projekt in diesem Bild ist komprimiert. Der Editor liest nur unkomprimierte Projekte.',
};
