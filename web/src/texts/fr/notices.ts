/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'La carte graphique ne répond plus : l’image ne peut pas être affichée.';

const inRows = (rows: boolean): string => (rows ? ', en rangées régulières faute de contour à suivre' : '');

/** @param source the name of a picture, which may be empty. */
const belongs = (project: string, source: string, width: number, height: number): string =>
  `${project} est fait pour ${source ? `l’image ${source}` : 'une autre image'} (${width} × ${height} px).`;

export const notices: Texts['notices'] = {
  nothingToHold: 'Il n’y a rien à tenir ici : placez la poignée sur l’image.',
  lassoOutside: 'En dehors de la sélection, l’image reste immobile.',
  lassoEmpty: 'Le lasso est vide : entourez une partie de l’image.',
  lassoFilled: 'Seule cette partie se déforme maintenant, sur un fond rempli.',
  lassoLoose: 'Seule cette partie se déforme maintenant. Elle laisse un vide là d’où elle s’éloigne.',
  partOnFrame: 'La partie longe le cadre de l’image, qui est maintenu : elle ne peut pas tourner.',
  leftOut: (count) =>
    plural(count, {
      one: 'Une poignée hors du lasso a été retirée. Annuler la rétablit.',
      other: `${count} poignées hors du lasso ont été retirées. Annuler les rétablit.`,
    }),
  notKept:
    'Votre travail n’est pas conservé dans ce navigateur : son stockage est plein ou bloqué. Enregistrez le projet avant de partir.',
  otherTab:
    'Un autre onglet a aussi modifié ce travail. Les deux versions sont conservées : elles seront proposées au rechargement.',
  twoVersions: (picture) => `${picture} a été modifié dans deux onglets. Voici la version la plus récente.`,
  graphicsLost: `${GRAPHICS_LOST} Rechargez la page.`,
  graphicsLostStored: `${GRAPHICS_LOST} Rien n’est perdu : rechargez la page.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Rien n’est encore perdu : enregistrez le projet, puis rechargez la page.`,
  clipNameTaken: (name) => `Un autre clip porte le nom ${quoted(name)}. L’ancien nom reste.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Une partie de cette poignée est hors de l’image et ne déplace rien : ${handles[0]}.`,
      other: `Des parties de ces poignées sont hors de l’image et ne déplacent rien : ${fewNames(handles)}.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Une partie de cette poignée est hors du lasso et ne déplace rien : ${handles[0]}.`,
      other: `Des parties de ces poignées sont hors du lasso et ne déplacent rien : ${fewNames(handles)}.`,
    }),
  nameStays: {
    empty: (name) => `Il faut un nom à une poignée : ${quoted(name)} garde le sien.`,
    taken: (name) => `Une autre poignée porte ce nom : ${quoted(name)} garde le sien.`,
  },
  outlineSimplified: 'Ce contour est très fin : il est suivi de moins près.',
  outlineBridged: (pixels) =>
    `Ce contour est trop fin pour être suivi : les parties distantes de ${pixels} pixels au plus se déforment ensemble.`,
  outlinePicture: 'Ce contour est trop fin pour être suivi : toute l’image se déforme.',
  looseParts: (count) =>
    plural(count, {
      one: 'Une partie n’a pas de poignée et reste en place.',
      other: `${count} parties n’ont pas de poignée et restent en place.`,
    }),
  sameThere: 'Les deux côtés sont déjà identiques.',
  noOtherSide: (handles) => `L’image n’a rien de l’autre côté : ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Aucune poignée d’ici ne correspond à cette pose : ${handles[0]}.`,
      other: `Aucune poignée d’ici ne correspond à ces poses : ${fewNames(handles)}.`,
    }),
  brushedStill: 'Les poignées sont au repos. Les traits du pinceau restent.',

  noPose: 'Il n’y a pas de pose dans le presse-papiers : copiez-en une d’abord.',
  badPose: (detail) => `Cette pose ne peut pas être collée : ${detail}.`,
  notCopied: 'Le navigateur a bloqué le presse-papiers : la pose ne peut être collée que sur cette page.',
  notCopiedByMenu: (keys) =>
    `Le navigateur a bloqué le presse-papiers : la pose ne peut être collée que sur cette page. ${keys} la copie pour d’autres pages.`,
  notRead: 'Le navigateur a bloqué le presse-papiers : autorisez-le pour coller.',
  notReadByMenu: (keys) => `Le navigateur a bloqué le presse-papiers : appuyez sur ${keys} pour coller.`,

  emptyAddress: 'Il n’y a pas d’adresse : entrez-en une qui commence par https://',
  noAddress: (text) =>
    `${quoted(text)} n’est pas l’adresse d’une image : elle doit commencer par https:// ou data:image/.`,
  nothingDropped: 'Ce dépôt ne contient ni image, ni adresse d’une image.',
  notCarried: (picture, why) => `Seule l’image a été ouverte : ${picture}. ${why}`,
  removed: (picture) => `Retiré de la liste : ${picture}.`,
  removedAll: (count) =>
    plural(count, {
      one: `${number(count)} image a été retirée de la liste.`,
      other: `${number(count)} images ont été retirées de la liste.`,
    }),
  notOpened: (file, more) =>
    `Une seule image s’ouvre à la fois. ${
      more === 0
        ? `Fichier non ouvert : ${file}.`
        : `Fichiers non ouverts : ${file} et ${plural(more, { one: `${more} autre`, other: `${more} autres` })}.`
    }`,
  moves: (picture) => `${picture} est une image animée. Seule sa première image est ouverte.`,
  lacksTexts: (picture) =>
    `${picture} est long à tracer, il est donc ouvert sans ses textes. Convertissez-les en chemins pour les voir.`,
  isOpen: (picture) => `Image ouverte : ${picture}.`,
  saved: (file) => `Enregistré sous ${file}.`,
  savedCut: (file) => `Enregistré sous ${file}. Ce qui dépasse du cadre est coupé.`,
  selectOne: 'Cela concerne une poignée : sélectionnez-la d’abord.',

  awaiting: (project, source, width, height) =>
    `${belongs(project, source, width, height)} Ouvrez cette image pour continuer.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongs(project, source, width, height)} Ouvrez cette image pour continuer, ou utilisez son rig sur ${picture}.`,
  theProject: 'Le projet',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `Cette poignée était à côté de l’image et y a été ramenée : ${handles[0]}.`,
      other: `Ces poignées étaient à côté de l’image et y ont été ramenées : ${fewNames(handles)}.`,
    }),

  folds: 'L’image fait un pli.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} plie l’image.`,
      other: `${fewNames(handles, quoted)} plient l’image entre elles.`,
    }),
  leftFolds: (handles) => `Retour à la pose sans plis la plus proche : ${fewNames(handles, quoted)}.`,
  noWayOut: 'Aucune pose sans plis n’a été trouvée entre celle-ci et la pose de repos.',

  placed: (added, rows) =>
    `${plural(added, {
      one: `${number(added)} poignée placée`,
      other: `${number(added)} poignées placées`,
    })}${inRows(rows)}. Faites-en glisser une pour déformer l’image.`,
  added: (added, there, rows) =>
    `${plural(added, {
      one: `${number(added)} poignée ajoutée`,
      other: `${number(added)} poignées ajoutées`,
    })}${inRows(rows)}. ${plural(there, {
      one: 'Celle qui était là reste.',
      other: `Les ${number(there)} qui étaient là restent.`,
    })}`,
  noSuggestion:
    'Aucune poignée n’a été ajoutée : il y en a déjà une près de chaque endroit qui en recevrait.',
  noPlace: 'Cette image n’a pas de place pour une poignée.',

  noKeysSelected: 'Aucune clé n’est sélectionnée.',
  noCopiedKeys: 'Aucune clé n’a été copiée.',
  copiedKeys: (count) =>
    plural(count, { one: `${number(count)} clé copiée`, other: `${number(count)} clés copiées` }),
  keysLeftOut: (count) =>
    plural(count, {
      one: '1 clé a été omise : après la fin du clip, ou d’une poignée absente d’ici.',
      other: `${count} clés ont été omises : après la fin du clip, ou d’une poignée absente d’ici.`,
    }),

  newVersion: 'Une nouvelle version est prête. Elle s’ouvrira au prochain démarrage.',
  newVersionWaits:
    'Une nouvelle version est prête. Elle s’ouvrira une fois les autres fenêtres de l’éditeur fermées.',
  notOffline:
    'L’éditeur n’est pas stocké pour un usage hors ligne : le téléchargement s’est interrompu. Le prochain démarrage réessaiera.',
  shareFailed: 'L’image partagée n’est pas arrivée. Ouvrez son fichier ici.',
  notGiven: (file) => `${file} ne peut pas être lu : il a été déplacé ou modifié. Ouvrez-le ici.`,
};

/** The words of buttons in notices. */
export const answers: Texts['answers'] = {
  tryAgain: 'Réessayer',
  takeBack: 'Revenir en arrière',
  exportAll: 'Tout exporter',
  holdBoundary: 'Maintenir son bord',
  extendSelection: 'Étendre la sélection',
  letFollow: 'Les faire suivre',
  putBack: 'Remettre',
  showOtherVersion: 'Voir l’autre version',
  keepThis: 'Garder celle-ci',
  backTo: (picture) => `Revenir à ${picture}`,
  openPicture: 'Ouvrir l’image',
  useRig: 'Utiliser ce rig',
};
