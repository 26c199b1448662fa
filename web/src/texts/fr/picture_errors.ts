/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'Le fichier est vide.',
  unreadable:
    'Impossible de lire le fichier. C’est un dossier, ou il a été déplacé ou modifié. Choisissez-le de nouveau.',
  incomplete:
    'L’image est incomplète : la fin du fichier manque. Téléchargez ou copiez de nouveau le fichier.',
  unknown: 'Ce navigateur ne sait pas lire le fichier comme image. Utilisez PNG, JPEG ou WebP.',
  otherKind: (kind) => `C’est ${kind}. Enregistrez le fichier en PNG, JPEG ou WebP.`,
  kinds: {
    png: 'une image PNG',
    jpeg: 'une image JPEG',
    gif: 'une image GIF',
    webp: 'une image WebP',
    avif: 'une image AVIF',
    heic: 'une image HEIC',
    bmp: 'une image BMP',
    icon: 'une icône',
    tiff: 'une image TIFF',
    photoshop: 'un document Photoshop',
    pdf: 'un document PDF',
    postscript: 'un document PostScript',
    jpegXl: 'une image JPEG XL',
    jpeg2000: 'une image JPEG 2000',
    svg: 'un dessin SVG',
    compressed: 'un fichier compressé',
  },
  damaged:
    'L’image est endommagée, ou ce navigateur ne sait pas la lire. Enregistrez-la de nouveau en PNG, JPEG ou WebP.',
  tooSmall: (width, height, least) =>
    `L’image fait ${width} × ${height} px. Elle doit faire au moins ${least} × ${least} px.`,
  tooLong: (width, height, most) =>
    `L’image fait ${width} × ${height} px. Chaque côté peut faire au plus ${number(most)} px. Réduisez l’image.`,
  tooLarge: (width, height, millions) =>
    `L’image fait ${width} × ${height} px. Elle peut compter au plus ${millions} millions de pixels. Réduisez-la.`,
  drawingDamaged: 'Le dessin est endommagé, ou ce navigateur ne sait pas l’afficher.',
  drawingWithoutSize: 'Le dessin n’a pas de taille. Donnez-lui une largeur et une hauteur, ou une viewBox.',
  drawingTooLarge: 'Le dessin dépasse 64 Mo. Simplifiez-le.',
  drawingEncoding: (encoding) => `Le dessin ne peut pas être lu en ${encoding}. Enregistrez-le en UTF-8.`,
  drawingRefused: (detail) => `Le dessin ne peut pas être ouvert : ${detail}`,
  noWebgl:
    'Ce navigateur ne peut pas lire des images avec WebGL2. Activez l’accélération matérielle ou utilisez un autre navigateur.',
  contextLost:
    'Le navigateur a perdu l’accès à la carte graphique pendant la lecture de l’image. Ouvrez l’image de nouveau.',
};

/** Errors of addresses. */
export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `Impossible de charger ${file} : le serveur a répondu ${status}.`,
  webPage: (file) => `${file} est une page web. Entrez l’adresse de l’image elle-même.`,
  unreachable: (file) => `Impossible de charger ${file}. Vérifiez l’adresse et la connexion.`,
  refused: (file, host) =>
    `Impossible de charger ${file}. ${host} ne laisse pas cette page le lire (CORS), ou est injoignable. Enregistrez l’image, puis ouvrez le fichier.`,
  damaged: 'L’image dans l’adresse est endommagée. Copiez-la à nouveau, ou enregistrez-la dans un fichier.',
};

/** Errors of projects in pictures. */
export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'Le projet dans cette image est trop volumineux.',
  damaged: 'Le projet dans cette image est endommagé.',
  compressed: 'Le projet dans cette image est compressé. L’éditeur ne lit que les projets non compressés.',
};
