/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'Le navigateur n’a plus accès à la carte graphique et ne peut pas afficher l’image.';

const inRows = (rows: boolean): string =>
  rows ? ' en rangées régulières, car l’image n’a pas de contour' : '';

/** @param source the name of a picture, which may be empty. */
const belongs = (project: string, source: string, width: number, height: number): string =>
  `${project} est fait pour ${source ? `l’image ${source}` : 'une autre image'} (${width} × ${height} px).`;

export const notices: Texts['notices'] = {
  nothingToHold: 'Placez la poignée sur l’image.',
  lassoOutside: 'L’image ne se déforme pas en dehors de la sélection.',
  lassoEmpty: 'Le lasso est vide. Entourez une partie de l’image.',
  drawingEnded: 'Le tracé est terminé.',
  lassoFilled: 'Seule cette partie se déforme maintenant, sur un fond rempli.',
  lassoLoose: 'Seule cette partie se déforme maintenant. Elle laisse un vide là d’où elle s’éloigne.',
  partOnFrame: 'La partie touche le bord verrouillé de l’image : elle ne peut pas tourner.',
  leftOut: (count) =>
    plural(count, {
      one: 'Une poignée hors du lasso a été retirée. « Annuler » la rétablit.',
      other: `${count} poignées hors du lasso ont été retirées. « Annuler » les rétablit.`,
    }),
  notKept:
    'Ce navigateur ne peut pas conserver votre travail : son stockage est plein ou bloqué. Enregistrez le projet avant de partir.',
  newerWork:
    'Ce navigateur contient un travail d’une version plus récente de l’éditeur, qui est conservé. Rechargez la page pour mettre à jour, ou enregistrez le projet avant de partir.',
  otherTab:
    'Un autre onglet a aussi modifié ce travail. Les deux versions sont conservées. Rechargez la page pour en choisir une.',
  twoVersions: (picture) => `${picture} a été modifié dans deux onglets. Voici la version la plus récente.`,
  graphicsLost: `${GRAPHICS_LOST} Rechargez la page.`,
  graphicsLostStored: `${GRAPHICS_LOST} Votre travail est en sécurité. Rechargez la page.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Enregistrez le projet, puis rechargez la page.`,
  clipNameTaken: (name) => `Un autre clip s’appelle déjà ${quoted(name)}. Le nom n’a pas été modifié.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Une partie de cette poignée est hors de l’image et n’a aucun effet : ${handles[0]}.`,
      other: `Des parties de ces poignées sont hors de l’image et n’ont aucun effet : ${fewNames(handles)}.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Une partie de cette poignée est hors du lasso et n’a aucun effet : ${handles[0]}.`,
      other: `Des parties de ces poignées sont hors du lasso et n’ont aucun effet : ${fewNames(handles)}.`,
    }),
  nameStays: {
    empty: (name) => `Une poignée doit avoir un nom. Le nom ${quoted(name)} a été conservé.`,
    taken: (name) => `Une autre poignée porte ce nom. Le nom ${quoted(name)} a été conservé.`,
  },
  outlineSimplified: 'Ce contour est très fin : la déformation le suit de moins près.',
  outlineBridged: (pixels) =>
    `Ce contour est trop fin pour être suivi : les parties distantes de ${pixels} pixels au plus se déforment ensemble.`,
  outlinePicture: 'Ce contour est trop fin pour être suivi : toute l’image se déforme.',
  looseParts: (count) =>
    plural(count, {
      one: 'Une partie n’a pas de poignée et reste en place.',
      other: `${count} parties n’ont pas de poignée et restent en place.`,
    }),
  sameThere: 'Les deux côtés correspondent déjà.',
  noOtherSide: (handles) => `La position reflétée est hors de l’image : ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Aucune poignée d’ici ne correspond à cette pose : ${handles[0]}.`,
      other: `Aucune poignée d’ici ne correspond à ces poses : ${fewNames(handles)}.`,
    }),
  brushedStill: 'Toutes les poignées ont été réinitialisées. Les traits du pinceau restent.',

  noPose: 'Le presse-papiers ne contient pas de pose. Copiez-en une d’abord.',
  badPose: (detail) => `Impossible de coller cette pose : ${detail}.`,
  badKeys: (detail) => `Impossible de coller ces clés : ${detail}.`,
  notCopied:
    'Le navigateur a bloqué le presse-papiers. Vous pouvez coller la copie sur cette page seulement.',
  notCopiedByMenu: (keys) =>
    `Le navigateur a bloqué le presse-papiers. Vous pouvez coller la copie sur cette page seulement. Pour la copier vers d’autres pages, appuyez sur ${keys}.`,
  notRead: 'Le navigateur a bloqué le presse-papiers. Autorisez l’accès pour coller.',
  notReadByMenu: (keys) => `Le navigateur a bloqué le presse-papiers. Appuyez sur ${keys} pour coller.`,

  emptyAddress: 'Entrez une adresse qui commence par https://.',
  noAddress: (text) =>
    `${quoted(text)} n’est pas l’adresse d’une image. Entrez-en une qui commence par https:// ou data:image/.`,
  nothingDropped: 'Déposez une image ou un lien vers une image.',
  notCarried: (picture, why) => `${picture} a été ouvert sans son projet. ${why}`,
  removed: (picture) => `Retiré de la liste : ${picture}.`,
  removedAll: (count) =>
    plural(count, {
      one: `${number(count)} image a été retirée de la liste.`,
      other: `${number(count)} images ont été retirées de la liste.`,
    }),
  notOpened: (file, more) =>
    `Une seule image peut s’ouvrir à la fois. ${
      more === 0
        ? `Fichier non ouvert : ${file}.`
        : `Fichiers non ouverts : ${file} et ${plural(more, { one: `${more} autre`, other: `${more} autres` })}.`
    }`,
  moves: (picture) => `${picture} est une image animée. Seule sa première image a été ouverte.`,
  lacksTexts: (picture) =>
    `${picture} est long à tracer et a donc été ouvert sans ses textes. Convertissez-les en chemins pour les voir.`,
  isOpen: (picture) => `Image ouverte : ${picture}.`,
  saved: (file) => `Enregistré sous ${file}.`,
  savedCut: (file) => `Enregistré sous ${file}. Ce qui dépasse du cadre a été coupé.`,
  selectOne: 'Sélectionnez d’abord une poignée.',

  awaiting: (project, source, width, height) =>
    `${belongs(project, source, width, height)} Ouvrez cette image pour continuer.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongs(project, source, width, height)} Ouvrez cette image pour continuer, ou utilisez ce rig sur ${picture}.`,
  theProject: 'Le projet',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `Cette poignée était hors de l’image et y a été ramenée : ${handles[0]}.`,
      other: `Ces poignées étaient hors de l’image et y ont été ramenées : ${fewNames(handles)}.`,
    }),

  folds: 'L’image se replie sur elle-même.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} plie l’image.`,
      other: `${fewNames(handles, quoted)} plient ensemble l’image.`,
    }),
  leftFolds: (handles) => `Retour à la pose sans plis la plus proche : ${fewNames(handles, quoted)}.`,
  noWayOut: 'Aucune pose sans plis n’a été trouvée entre cette pose et la pose initiale.',

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
      one: 'La poignée existante reste.',
      other: `Les ${number(there)} poignées existantes restent.`,
    })}`,
  noSuggestion: 'Aucune poignée n’a été ajoutée : il y en a déjà une près de chaque endroit adapté.',
  noPlace: 'Cette image n’a pas de place pour une poignée.',

  noKeysSelected: 'Sélectionnez d’abord des clés.',
  noCopiedKeys: 'Copiez d’abord des clés.',
  copiedKeys: (count) =>
    plural(count, { one: `${number(count)} clé copiée`, other: `${number(count)} clés copiées` }),
  keysLeftOut: (count) =>
    plural(count, {
      one: '1 clé a été omise. Elle dépasse la fin du clip, ou sa poignée manque.',
      other: `${count} clés ont été omises. Elles dépassent la fin du clip, ou leurs poignées manquent.`,
    }),

  newVersion: 'Une nouvelle version est prête. Elle démarrera à la prochaine ouverture de l’éditeur.',
  newVersionWaits:
    'Une nouvelle version est prête. Elle démarrera quand vous aurez fermé toutes les autres fenêtres de l’éditeur.',
  notOffline:
    'L’éditeur ne fonctionne pas encore hors ligne : le téléchargement a été interrompu. Il reprendra au prochain démarrage.',
  offered: (files) => `Un lien ou un autre programme veut ouvrir ${fewNames(files)}.`,
  shareFailed: 'Impossible de recevoir l’image partagée. Ouvrez son fichier ici.',
  notGiven: (file) => `Impossible de lire ${file} : il a été déplacé ou modifié. Ouvrez-le ici.`,
};

/** The words of buttons in notices. */
export const answers: Texts['answers'] = {
  tryAgain: 'Réessayer',
  continueDrawing: 'Reprendre le tracé',
  takeBack: 'Effacer les traits',
  exportAll: 'Exporter toute l’image',
  holdBoundary: 'Verrouiller son contour',
  extendSelection: 'Étendre la sélection',
  letFollow: 'Les faire suivre',
  putBack: 'Restaurer',
  showOtherVersion: 'Voir l’autre version',
  keepThis: 'Garder celle-ci',
  backTo: (picture) => `Revenir à ${picture}`,
  open: 'Ouvrir',
  openPicture: 'Ouvrir l’image',
  useRig: 'Utiliser ce rig',
};
