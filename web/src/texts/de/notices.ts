import type { Texts } from '../texts';
import { counted, fewNames, handleCount, keyCount, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'Die Grafikkarte ist weg, darum kann das Bild nicht gezeigt werden.';

const inRows = (rows: boolean): string =>
  rows ? ' in gleichmäßigen Reihen, weil es keinen Umriss gibt, dem sie folgen könnten' : '';

const belongsTo = (project: string, source: string, width: number, height: number): string =>
  `${project} gehört zu ${source ? `dem Bild ${source}` : 'einem anderen Bild'} (${width} × ${height} px).`;

export const notices: Texts['notices'] = {
  nothingToHold: 'Hier gibt es nichts zu halten: den Griff auf das Bild setzen.',
  lassoOutside: 'Außerhalb der Auswahl bleibt das Bild unbewegt.',
  lassoEmpty: 'Das Lasso ist leer: einen Teil des Bilds damit umfahren.',
  lassoFilled: 'Nur dieser Teil biegt sich jetzt, über einem gefüllten Hintergrund.',
  lassoLoose: 'Nur dieser Teil biegt sich jetzt. Wo er sich wegbewegt, bleibt eine Lücke.',
  partOnFrame: 'Der Teil liegt am Rahmen des Bilds, der festgehalten wird: Er kann sich nicht drehen.',
  leftOut: (count) =>
    plural(count, {
      one: 'Ein Griff außerhalb des Lassos wurde entfernt. Rückgängig bringt ihn zurück.',
      other: `${count} Griffe außerhalb des Lassos wurden entfernt. Rückgängig bringt sie zurück.`,
    }),
  notKept:
    'Die Arbeit ist nicht in diesem Browser gespeichert: Sein Speicher ist voll oder gesperrt. Vor dem Verlassen das Projekt speichern.',
  otherTab:
    'Auch ein anderer Tab hat diese Arbeit geändert. Beide Fassungen bleiben erhalten: Nach dem Neuladen stehen sie zur Wahl.',
  twoVersions: (picture) => `${picture} wurde in zwei Tabs geändert. Dies ist die spätere Fassung.`,
  graphicsLost: `${GRAPHICS_LOST} Die Seite neu laden.`,
  graphicsLostStored: `${GRAPHICS_LOST} Nichts ist verloren: die Seite neu laden.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Noch ist nichts verloren: das Projekt speichern, dann die Seite neu laden.`,
  clipNameTaken: (name) => `Ein anderer Clip heißt schon ${quoted(name)}. Der alte Name bleibt.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Ein Teil von ${handles[0]} liegt außerhalb des Bilds und bewegt nichts.`,
      other: `Teile von ${fewNames(handles)} liegen außerhalb des Bilds und bewegen nichts.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Ein Teil von ${handles[0]} liegt außerhalb des Lassos und bewegt nichts.`,
      other: `Teile von ${fewNames(handles)} liegen außerhalb des Lassos und bewegen nichts.`,
    }),
  nameStays: {
    empty: (name) => `Ein Griff braucht einen Namen: ${quoted(name)} behält seinen.`,
    taken: (name) => `Ein anderer Griff hat diesen Namen: ${quoted(name)} behält seinen.`,
  },
  outlineSimplified: 'Dieser Umriss ist sehr fein, darum wird er weniger genau verfolgt.',
  outlineBridged: (pixels) =>
    `Dieser Umriss ist zu fein, um ihm zu folgen: Teile, die bis zu ${pixels} Pixel auseinanderliegen, biegen sich gemeinsam.`,
  outlinePicture: 'Dieser Umriss ist zu fein, um ihm zu folgen: Das ganze Bild biegt sich.',
  looseParts: (count) =>
    plural(count, {
      one: 'Ein Teil hat keinen Griff und bleibt zurück.',
      other: `${count} Teile haben keinen Griff und bleiben zurück.`,
    }),
  sameThere: 'Beide Seiten sind schon gleich.',
  noOtherSide: (handles) => `Das Bild hat auf der anderen Seite nichts für: ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Kein Griff hier passt zur Pose von ${handles[0]}.`,
      other: `Keine Griffe hier passen zu den Posen von ${fewNames(handles)}.`,
    }),
  brushedStill: 'Die Griffe sind in Ruhe. Pinselstriche bleiben.',

  noPose: 'In der Zwischenablage ist keine Pose: zuerst eine kopieren.',
  badPose: (detail) => `Diese Pose kann nicht eingefügt werden: ${detail}.`,
  notCopied:
    'Der Browser hat die Zwischenablage gesperrt: Die Pose kann nur auf dieser Seite eingefügt werden.',
  notCopiedByMenu: (keys) =>
    `Der Browser hat die Zwischenablage gesperrt: Die Pose kann nur auf dieser Seite eingefügt werden. ${keys} kopiert sie für andere Seiten.`,
  notRead: 'Der Browser hat die Zwischenablage gesperrt: sie zum Einfügen freigeben.',
  notReadByMenu: (keys) => `Der Browser hat die Zwischenablage gesperrt: zum Einfügen ${keys} drücken.`,

  emptyAddress: 'Es gibt keine Adresse: eine eingeben, die mit https:// beginnt',
  noAddress: (text) =>
    `${quoted(text)} ist keine Adresse eines Bilds: Sie muss mit https:// oder data:image/ beginnen.`,
  nothingDropped: 'Hier wurde kein Bild abgelegt, und auch keine Adresse eines Bilds.',
  notCarried: (picture, why) => `${picture} wurde nur als Bild geöffnet. ${why}`,
  removed: (picture) => `${picture} wurde aus der Liste entfernt.`,
  removedAll: (count) =>
    plural(count, {
      one: 'Ein Bild wurde aus der Liste entfernt.',
      other: `${count} Bilder wurden aus der Liste entfernt.`,
    }),
  notOpened: (file, more) =>
    more === 0
      ? `Es öffnet sich immer nur ein Bild. Nicht geöffnet: ${file}.`
      : `Es öffnet sich immer nur ein Bild. Nicht geöffnet: ${file} und ${counted(more, 'weitere Datei', 'weitere Dateien')}.`,
  moves: (picture) => `${picture} ist bewegt. Nur das erste Einzelbild ist offen.`,
  lacksTexts: (picture) =>
    `${picture} braucht lange zum Zeichnen und ist deshalb ohne Texte geöffnet. Texte in Pfade umwandeln, um sie zu sehen.`,
  isOpen: (picture) => `${picture} ist offen.`,
  saved: (file) => `Gespeichert als ${file}.`,
  savedCut: (file) => `Gespeichert als ${file}. Der Teil außerhalb des Rahmens ist abgeschnitten.`,
  selectOne: 'Hier geht es um einen Griff: zuerst einen auswählen.',

  awaiting: (project, source, width, height) =>
    `${belongsTo(project, source, width, height)} Dieses Bild öffnen, um fortzufahren.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongsTo(project, source, width, height)} Dieses Bild öffnen, um fortzufahren, oder das Rig hier verwenden: ${picture}.`,
  theProject: 'Das Projekt',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `${handles[0]} lag neben diesem Bild und wurde darauf verschoben.`,
      other: `${fewNames(handles)} lagen neben diesem Bild und wurden darauf verschoben.`,
    }),

  folds: 'Das Bild faltet sich.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} faltet das Bild.`,
      other: `${fewNames(handles, quoted)} falten das Bild zwischen sich.`,
    }),
  leftFolds: (handles) => `Zur nächsten Pose ohne Falten zurückbewegt: ${fewNames(handles, quoted)}.`,
  noWayOut: 'Zwischen dieser Pose und der Ruhepose wurde keine ohne Falten gefunden.',

  placed: (added, rows) =>
    `${handleCount(added)} gesetzt${inRows(rows)}. An einem ziehen, um das Bild zu biegen.`,
  added: (added, there, rows) =>
    `${handleCount(added)} hinzugefügt${inRows(rows)}. ${plural(there, {
      one: 'Der vorhandene bleibt.',
      other: `Die ${number(there)} vorhandenen bleiben.`,
    })}`,
  noSuggestion: 'Kein Griff wurde hinzugefügt: Überall, wo einer hinkäme, ist schon einer in der Nähe.',
  noPlace: 'In diesem Bild ist kein Platz für einen Griff.',

  noKeysSelected: 'Keine Keyframes sind ausgewählt.',
  noCopiedKeys: 'Es wurden keine Keyframes kopiert.',
  copiedKeys: (count) => `${keyCount(count)} kopiert`,
  keysLeftOut: (count) =>
    plural(count, {
      one: '1 Keyframe wurde ausgelassen: hinter dem Ende des Clips oder von einem Griff, der hier fehlt.',
      other: `${count} Keyframes wurden ausgelassen: hinter dem Ende des Clips oder von einem Griff, der hier fehlt.`,
    }),

  newVersion: 'Eine neue Version ist bereit. Sie öffnet sich beim nächsten Start.',
  newVersionWaits:
    'Eine neue Version ist bereit. Sie öffnet sich, sobald die anderen Fenster des Editors geschlossen sind.',
  notOffline:
    'Der Editor ist nicht für die Nutzung ohne Netz gespeichert: Der Download brach ab. Der nächste Start versucht es erneut.',
  shareFailed: 'Das geteilte Bild ist nicht angekommen. Die Datei hier öffnen.',
  notGiven: (file) =>
    `${file} kann nicht gelesen werden: Die Datei wurde verschoben oder geändert. Sie hier öffnen.`,
};

export const answers: Texts['answers'] = {
  tryAgain: 'Erneut versuchen',
  takeBack: 'Zurücknehmen',
  exportAll: 'Alles exportieren',
  holdBoundary: 'Rand festhalten',
  extendSelection: 'Auswahl erweitern',
  letFollow: 'Folgen lassen',
  putBack: 'Zurücklegen',
  showOtherVersion: 'Andere Fassung zeigen',
  keepThis: 'Diese behalten',
  backTo: (picture) => `Zurück zu ${picture}`,
  openPicture: 'Bild öffnen',
  useRig: 'Dieses Rig verwenden',
};
