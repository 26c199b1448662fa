/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'Le fichier est vide.',
  unreadable:
    'Le fichier ne peut pas être lu : c’est un dossier, ou il a été déplacé ou modifié. Choisissez-le de nouveau.',
  incomplete: 'L’image est incomplète : la fin du fichier manque. Récupérez le fichier à nouveau.',
  unknown: 'Le fichier n’est pas une image que ce navigateur sait lire. Utilisez PNG, JPEG ou WebP.',
  otherKind: (kind) => `Le fichier est ${kind}. Enregistrez-le en PNG, JPEG ou WebP.`,
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
    `L’image fait ${width} × ${height} px. Un côté peut faire au plus ${number(most)} px : réduisez l’image.`,
  tooLarge: (width, height, millions) =>
    `L’image fait ${width} × ${height} px. Elle peut compter au plus ${millions} millions de pixels : réduisez l’image.`,
  drawingDamaged: 'Le dessin est endommagé, ou ce navigateur ne sait pas l’afficher.',
  drawingWithoutSize: 'Le dessin n’a pas de taille. Donnez-lui une largeur et une hauteur, ou une viewBox.',
  drawingTooLarge: 'Le dessin dépasse 64 Mo. Simplifiez-le.',
  drawingEncoding: (encoding) => `Le dessin ne peut pas être lu en ${encoding}. Enregistrez-le en UTF-8.`,
  drawingUnread: 'Le dessin n’a pas pu être lu. Vérifiez la connexion et ouvrez-le à nouveau.',
  drawingTooManyElements: (most) => `Le dessin a plus de ${number(most)} éléments. Simplifiez-le.`,
  drawingTooManyAttributes: (most) => `Un élément du dessin a plus de ${most} attributs. Retirez-en.`,
  drawingTooDeep: (most) =>
    `Des éléments du dessin sont imbriqués sur plus de ${most} niveaux. Dégroupez-en.`,
  drawingTooManyCopies:
    'Des éléments du dessin sont réutilisés trop souvent. Choisissez-en de plus petits, ou réutilisez-les moins.',
  drawingTooManyStyles: 'Les styles du dessin prennent trop de temps. Simplifiez-les.',
  drawingTooSlow: (element) =>
    `Le dessin prend trop de temps à tracer, surtout ses <${element}>. Simplifiez-le.`,
  drawingTooMuchMemory: (element) =>
    `Le dessin prend trop de mémoire à tracer, surtout ses <${element}>. Simplifiez-le.`,
  noWebgl:
    'Ce navigateur ne peut pas lire des images avec WebGL2. Activez l’accélération matérielle ou utilisez un autre navigateur.',
  contextLost: 'Le contexte graphique a été perdu pendant la lecture de l’image. Ouvrez l’image à nouveau.',
};

/** Errors of addresses. */
export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `${file} n’a pas pu être chargé : le serveur a répondu ${status}.`,
  webPage: (file) =>
    `${file} n’a pas pu être chargé : c’est une page web. Donnez l’adresse de l’image elle-même.`,
  unreachable: (file) => `${file} n’a pas pu être chargé. Vérifiez l’adresse et la connexion au réseau.`,
  refused: (file, host) =>
    `${file} n’a pas pu être chargé. ${host} ne laisse pas cette page le lire (CORS), ou est injoignable. Enregistrez l’image, puis ouvrez le fichier.`,
  damaged: 'L’image dans l’adresse est endommagée. Copiez-la à nouveau, ou enregistrez-la dans un fichier.',
};

/** Errors of projects in pictures. */
export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'Le projet dans cette image est trop long.',
  damaged: 'Le projet dans cette image est endommagé.',
  compressed: 'Le projet dans cette image est compressé, ce qui n’est pas pris en charge.',
};
