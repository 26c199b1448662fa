import type { Texts } from '../texts';
import { counted, fewNames, handleCount, keyCount, number, plural, quoted } from './language';

const GRAPHICS_LOST =
  'Der Browser hat keinen Zugriff mehr auf die Grafikkarte und kann das Bild nicht anzeigen.';

const inRows = (rows: boolean): string =>
  rows ? ' in gleichmäßigen Reihen, weil das Bild keinen Umriss hat' : '';

const belongsTo = (project: string, source: string, width: number, height: number): string =>
  `${project} gehört zu ${source ? `dem Bild ${source}` : 'einem anderen Bild'} (${width} × ${height} px).`;

export const notices: Texts['notices'] = {
  nothingToHold: 'Setzen Sie den Griff auf das Bild.',
  lassoOutside: 'Außerhalb der Auswahl biegt sich das Bild nicht.',
  lassoEmpty: 'Das Lasso ist leer. Umfahren Sie damit einen Teil des Bilds.',
  drawingEnded: 'Die Zeichnung ist beendet.',
  lassoFilled: 'Nur dieser Teil biegt sich jetzt, über einem gefüllten Hintergrund.',
  lassoLoose: 'Nur dieser Teil biegt sich jetzt. Wo er sich wegbewegt, bleibt eine Lücke.',
  partOnFrame: 'Der Teil berührt den fixierten Rand des Bilds und kann sich darum nicht drehen.',
  leftOut: (count) =>
    plural(count, {
      one: 'Ein Griff außerhalb des Lassos wurde entfernt. „Rückgängig“ stellt ihn wieder her.',
      other: `${count} Griffe außerhalb des Lassos wurden entfernt. „Rückgängig“ stellt sie wieder her.`,
    }),
  notKept:
    'Dieser Browser kann Ihre Arbeit nicht speichern: Sein Speicher ist voll oder gesperrt. Speichern Sie das Projekt, bevor Sie die Seite verlassen.',
  newerWork:
    'Dieser Browser enthält Arbeit einer neueren Version des Editors, die erhalten bleibt. Zum Aktualisieren die Seite neu laden oder vor dem Verlassen das Projekt speichern.',
  otherTab:
    'Auch ein anderer Tab hat diese Arbeit geändert. Beide Fassungen bleiben erhalten. Laden Sie die Seite neu, um eine zu wählen.',
  twoVersions: (picture) => `${picture} wurde in zwei Tabs geändert. Dies ist die spätere Fassung.`,
  graphicsLost: `${GRAPHICS_LOST} Laden Sie die Seite neu.`,
  graphicsLostStored: `${GRAPHICS_LOST} Ihre Arbeit ist sicher. Laden Sie die Seite neu.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Speichern Sie das Projekt, und laden Sie dann die Seite neu.`,
  clipNameTaken: (name) => `Ein anderer Clip heißt schon ${quoted(name)}. Der Name wurde nicht geändert.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Ein Teil von ${handles[0]} liegt außerhalb des Bilds und hat keine Wirkung.`,
      other: `Teile von ${fewNames(handles)} liegen außerhalb des Bilds und haben keine Wirkung.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Ein Teil von ${handles[0]} liegt außerhalb des Lassos und hat keine Wirkung.`,
      other: `Teile von ${fewNames(handles)} liegen außerhalb des Lassos und haben keine Wirkung.`,
    }),
  nameStays: {
    empty: (name) => `Ein Griff braucht einen Namen. Der Name ${quoted(name)} bleibt.`,
    taken: (name) => `Ein anderer Griff hat diesen Namen. Der Name ${quoted(name)} bleibt.`,
  },
  outlineSimplified: 'Dieser Umriss ist sehr fein, darum folgt ihm die Biegung weniger genau.',
  outlineBridged: (pixels) =>
    `Dieser Umriss ist zu fein: Teile, die bis zu ${pixels} Pixel auseinanderliegen, biegen sich gemeinsam.`,
  outlinePicture: 'Dieser Umriss ist zu fein: Das ganze Bild biegt sich.',
  looseParts: (count) =>
    plural(count, {
      one: 'Ein Teil hat keinen Griff und bleibt stehen.',
      other: `${count} Teile haben keinen Griff und bleiben stehen.`,
    }),
  sameThere: 'Beide Seiten stimmen schon überein.',
  noOtherSide: (handles) => `Gespiegelt außerhalb des Bilds: ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Kein Griff hier passt zur Pose von ${handles[0]}.`,
      other: `Keine Griffe hier passen zu den Posen von ${fewNames(handles)}.`,
    }),
  brushedStill: 'Alle Griffe wurden zurückgesetzt. Die Pinselstriche bleiben.',

  noPose: 'Die Zwischenablage enthält keine Pose. Kopieren Sie zuerst eine.',
  badPose: (detail) => `Die Pose konnte nicht eingefügt werden: ${detail}.`,
  badKeys: (detail) => `Die Keyframes konnten nicht eingefügt werden: ${detail}.`,
  notCopied:
    'Der Browser hat die Zwischenablage gesperrt. Sie können die Kopie nur auf dieser Seite einfügen.',
  notCopiedByMenu: (keys) =>
    `Der Browser hat die Zwischenablage gesperrt. Sie können die Kopie nur auf dieser Seite einfügen. Für andere Seiten kopieren Sie sie mit ${keys}.`,
  notRead: 'Der Browser hat die Zwischenablage gesperrt. Erlauben Sie den Zugriff, um einzufügen.',
  notReadByMenu: (keys) => `Der Browser hat die Zwischenablage gesperrt. Drücken Sie zum Einfügen ${keys}.`,

  emptyAddress: 'Geben Sie eine Adresse ein, die mit https:// beginnt.',
  noAddress: (text) =>
    `${quoted(text)} ist keine Bildadresse. Geben Sie eine ein, die mit https:// oder data:image/ beginnt.`,
  nothingDropped: 'Legen Sie ein Bild oder einen Link zu einem Bild ab.',
  notCarried: (picture, why) => `${picture} wurde ohne sein Projekt geöffnet. ${why}`,
  removed: (picture) => `${picture} wurde aus der Liste entfernt.`,
  removedAll: (count) =>
    plural(count, {
      one: 'Ein Bild wurde aus der Liste entfernt.',
      other: `${count} Bilder wurden aus der Liste entfernt.`,
    }),
  notOpened: (file, more) =>
    more === 0
      ? `Es lässt sich nur ein Bild auf einmal öffnen. Nicht geöffnet: ${file}.`
      : `Es lässt sich nur ein Bild auf einmal öffnen. Nicht geöffnet: ${file} und ${counted(more, 'weitere Datei', 'weitere Dateien')}.`,
  moves: (picture) => `${picture} ist animiert. Nur das erste Einzelbild wurde geöffnet.`,
  lacksTexts: (picture) =>
    `${picture} braucht lange zum Zeichnen und wurde deshalb ohne Texte geöffnet. Wandeln Sie Texte in Pfade um, um sie zu sehen.`,
  isOpen: (picture) => `${picture} ist geöffnet.`,
  saved: (file) => `Gespeichert als ${file}.`,
  savedCut: (file) => `Gespeichert als ${file}. Teile außerhalb des Rahmens wurden abgeschnitten.`,
  selectOne: 'Wählen Sie zuerst einen Griff aus.',

  awaiting: (project, source, width, height) =>
    `${belongsTo(project, source, width, height)} Öffnen Sie dieses Bild, um fortzufahren.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongsTo(project, source, width, height)} Öffnen Sie dieses Bild, um fortzufahren, oder verwenden Sie das Rig für ${picture}.`,
  theProject: 'Das Projekt',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `${handles[0]} lag außerhalb dieses Bilds und wurde darauf verschoben.`,
      other: `${fewNames(handles)} lagen außerhalb dieses Bilds und wurden darauf verschoben.`,
    }),

  folds: 'Das Bild faltet sich.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} faltet das Bild.`,
      other: `${fewNames(handles, quoted)} falten zusammen das Bild.`,
    }),
  leftFolds: (handles) => `Zur nächstgelegenen Pose ohne Falten zurückbewegt: ${fewNames(handles, quoted)}.`,
  noWayOut: 'Zwischen dieser Pose und der Ausgangspose wurde keine ohne Falten gefunden.',

  placed: (added, rows) =>
    `${handleCount(added)} gesetzt${inRows(rows)}. Ziehen Sie an einem, um das Bild zu biegen.`,
  added: (added, there, rows) =>
    `${handleCount(added)} hinzugefügt${inRows(rows)}. ${plural(there, {
      one: 'Der vorhandene Griff bleibt.',
      other: `Die ${number(there)} vorhandenen Griffe bleiben.`,
    })}`,
  noSuggestion: 'Kein Griff wurde hinzugefügt: An jeder geeigneten Stelle gibt es schon einen.',
  noPlace: 'In diesem Bild ist kein Platz für einen Griff.',

  noKeysSelected: 'Wählen Sie zuerst Keyframes aus.',
  noCopiedKeys: 'Kopieren Sie zuerst Keyframes.',
  copiedKeys: (count) => `${keyCount(count)} kopiert`,
  keysLeftOut: (count) =>
    plural(count, {
      one: '1 Keyframe wurde ausgelassen. Er liegt hinter dem Ende des Clips, oder sein Griff fehlt.',
      other: `${count} Keyframes wurden ausgelassen. Sie liegen hinter dem Ende des Clips, oder ihre Griffe fehlen.`,
    }),

  newVersion: 'Eine neue Version ist bereit. Sie startet, wenn Sie den Editor das nächste Mal öffnen.',
  newVersionWaits:
    'Eine neue Version ist bereit. Sie startet, wenn Sie alle anderen Fenster des Editors geschlossen haben.',
  notOffline:
    'Der Editor funktioniert noch nicht offline: Der Download wurde unterbrochen. Er wird beim nächsten Start fortgesetzt.',
  offered: (files) => `Ein Link oder ein anderes Programm möchte etwas öffnen: ${fewNames(files)}.`,
  shareFailed: 'Das geteilte Bild konnte nicht empfangen werden. Öffnen Sie die Datei hier.',
  notGiven: (file) =>
    `${file} konnte nicht gelesen werden: Die Datei wurde verschoben oder geändert. Öffnen Sie sie hier.`,
};

export const answers: Texts['answers'] = {
  tryAgain: 'Erneut versuchen',
  continueDrawing: 'Weiterzeichnen',
  takeBack: 'Striche löschen',
  exportAll: 'Ganzes Bild exportieren',
  holdBoundary: 'Umriss fixieren',
  extendSelection: 'Auswahl erweitern',
  letFollow: 'Folgen lassen',
  putBack: 'Wiederherstellen',
  showOtherVersion: 'Andere Fassung anzeigen',
  keepThis: 'Diese behalten',
  backTo: (picture) => `Zurück zu ${picture}`,
  open: 'Öffnen',
  openPicture: 'Bild öffnen',
  useRig: 'Dieses Rig verwenden',
};
