/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { countedHandles, fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'El navegador ha perdido el acceso a la tarjeta gráfica y no puede mostrar la imagen.';

const inRows = (rows: boolean): string =>
  rows ? ' en filas regulares, porque la imagen no tiene contorno' : '';

const belonging = (project: string, source: string, width: number, height: number): string =>
  `${project} pertenece a ${source === '' ? 'otra imagen' : `la imagen ${source}`} (${width} × ${height} px).`;

export const notices: Texts['notices'] = {
  nothingToHold: 'Coloque el punto de control sobre la imagen.',
  lassoOutside: 'La imagen no se deforma fuera de la selección.',
  lassoEmpty: 'El lazo está vacío. Rodee con él una parte de la imagen.',
  drawingEnded: 'El dibujo ha terminado.',
  lassoFilled: 'Ahora solo se deforma esta parte, sobre un fondo relleno.',
  lassoLoose: 'Ahora solo se deforma esta parte. Deja un hueco donde se aleja.',
  partOnFrame: 'La parte toca el borde fijado de la imagen, así que no puede girar.',
  leftOut: (count) =>
    plural(count, {
      one: 'Se ha quitado un punto de control fuera del lazo. «Deshacer» lo recupera.',
      other: `Se han quitado ${count} puntos de control fuera del lazo. «Deshacer» los recupera.`,
    }),
  notKept:
    'Este navegador no puede guardar su trabajo: el almacenamiento está lleno o bloqueado. Guarde el proyecto antes de salir.',
  newerWork:
    'Este navegador contiene trabajo de una versión más reciente del editor, que se conserva. Recargue la página para actualizar o guarde el proyecto antes de salir.',
  otherTab:
    'Otra pestaña también ha cambiado este trabajo. Se conservan las dos versiones. Recargue la página para elegir una.',
  twoVersions: (picture) => `${picture} se ha cambiado en dos pestañas. Esta es la versión más reciente.`,
  graphicsLost: `${GRAPHICS_LOST} Recargue la página.`,
  graphicsLostStored: `${GRAPHICS_LOST} Su trabajo está a salvo. Recargue la página.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Guarde el proyecto y después recargue la página.`,
  clipNameTaken: (name) => `Otro clip ya se llama ${quoted(name)}. El nombre no se ha cambiado.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Una parte de ${handles[0]} queda fuera de la imagen y no tiene efecto.`,
      other: `Partes de ${fewNames(handles)} quedan fuera de la imagen y no tienen efecto.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Una parte de ${handles[0]} queda fuera del lazo y no tiene efecto.`,
      other: `Partes de ${fewNames(handles)} quedan fuera del lazo y no tienen efecto.`,
    }),
  nameStays: {
    empty: (name) => `Un punto de control necesita un nombre. Se mantiene el nombre ${quoted(name)}.`,
    taken: (name) => `Otro punto de control tiene este nombre. Se mantiene el nombre ${quoted(name)}.`,
  },
  outlineSimplified: 'Este contorno es muy fino, así que la deformación lo sigue con menos exactitud.',
  outlineBridged: (pixels) =>
    `Este contorno es demasiado fino para seguirlo: las partes separadas hasta ${pixels} píxeles se deforman juntas.`,
  outlinePicture: 'Este contorno es demasiado fino para seguirlo: se deforma toda la imagen.',
  looseParts: (count) =>
    plural(count, {
      one: 'Una parte no tiene punto de control y se queda en su sitio.',
      other: `${count} partes no tienen punto de control y se quedan en su sitio.`,
    }),
  sameThere: 'Los dos lados ya coinciden.',
  noOtherSide: (handles) => `La posición reflejada queda fuera de la imagen: ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Ningún punto de control corresponde aquí a la pose de ${handles[0]}.`,
      other: `Ningún punto de control corresponde aquí a las poses de ${fewNames(handles)}.`,
    }),
  brushedStill: 'Se han restablecido todos los puntos de control. Los trazos del pincel se mantienen.',

  noPose: 'El portapapeles no contiene ninguna pose. Copie una primero.',
  badPose: (detail) => `No se ha podido pegar esta pose: ${detail}.`,
  badKeys: (detail) => `No se han podido pegar estas claves: ${detail}.`,
  notCopied: 'El navegador ha bloqueado el portapapeles. Solo puede pegar la copia en esta página.',
  notCopiedByMenu: (keys) =>
    `El navegador ha bloqueado el portapapeles. Solo puede pegar la copia en esta página. Para copiarla a otras, pulse ${keys}.`,
  notRead: 'El navegador ha bloqueado el portapapeles. Permita el acceso para pegar.',
  notReadByMenu: (keys) => `El navegador ha bloqueado el portapapeles. Pulse ${keys} para pegar.`,

  emptyAddress: 'Escriba una dirección que empiece por https://.',
  noAddress: (text) =>
    `${quoted(text)} no es la dirección de una imagen. Escriba una que empiece por https:// o data:image/.`,
  nothingDropped: 'Suelte una imagen o un enlace a una.',
  notCarried: (picture, why) => `${picture} se ha abierto sin su proyecto. ${why}`,
  removed: (picture) => `Se ha quitado ${picture} de la lista.`,
  removedAll: (count) =>
    plural(count, {
      one: 'Se ha quitado 1 imagen de la lista.',
      other: `Se han quitado ${count} imágenes de la lista.`,
    }),
  notOpened: (file, more) =>
    `Solo se abre una imagen a la vez. Sin abrir: ${more === 0 ? file : `${file} y ${more} más`}.`,
  moves: (picture) => `${picture} es una animación. Solo se ha abierto el primer fotograma.`,
  lacksTexts: (picture) =>
    `${picture} tarda mucho en dibujarse, así que se ha abierto sin sus textos. Conviértalos en trazados para verlos.`,
  isOpen: (picture) => `Imagen abierta: ${picture}.`,
  saved: (file) => `Guardado como ${file}.`,
  savedCut: (file) => `Guardado como ${file}. Las partes fuera del marco se han cortado.`,
  selectOne: 'Seleccione primero un punto de control.',

  awaiting: (project, source, width, height) =>
    `${belonging(project, source, width, height)} Abra esa imagen para continuar.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belonging(project, source, width, height)} Abra esa imagen para continuar o use el rig en ${picture}.`,
  theProject: 'El proyecto',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `${handles[0]} quedaba fuera de esta imagen y se ha movido sobre ella.`,
      other: `${fewNames(handles)} quedaban fuera de esta imagen y se han movido sobre ella.`,
    }),

  folds: 'La imagen se pliega sobre sí misma.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} pliega la imagen.`,
      other: `${fewNames(handles, quoted)} pliegan juntos la imagen.`,
    }),
  leftFolds: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} ha vuelto a la pose más cercana sin pliegues.`,
      other: `${fewNames(handles, quoted)} han vuelto a la pose más cercana sin pliegues.`,
    }),
  noWayOut: 'No se ha encontrado ninguna pose sin pliegues entre esta y la inicial.',

  placed: (added, rows) =>
    `${plural(added, { one: 'Se ha colocado', other: 'Se han colocado' })} ${countedHandles(added)}${inRows(rows)}. Arrastre uno para deformar la imagen.`,
  added: (added, there, rows) =>
    `${plural(added, { one: 'Se ha añadido', other: 'Se han añadido' })} ${countedHandles(added)}${inRows(rows)}. ${plural(
      there,
      {
        one: 'El punto de control existente se mantiene.',
        other: `Los ${number(there)} puntos de control existentes se mantienen.`,
      },
    )}`,
  noSuggestion: 'No se ha añadido ningún punto de control: ya hay uno cerca de cada lugar adecuado.',
  noPlace: 'En esta imagen no cabe ningún punto de control.',

  noKeysSelected: 'Seleccione claves primero.',
  noCopiedKeys: 'Copie claves primero.',
  copiedKeys: (count) => plural(count, { one: '1 clave copiada', other: `${number(count)} claves copiadas` }),
  keysLeftOut: (count) =>
    plural(count, {
      one: 'Se ha omitido 1 clave: está más allá del final del clip o falta su punto de control.',
      other: `Se han omitido ${count} claves: están más allá del final del clip o faltan sus puntos de control.`,
    }),

  newVersion: 'Hay una versión nueva. Se iniciará la próxima vez que abra el editor.',
  newVersionWaits: 'Hay una versión nueva. Se iniciará cuando cierre las demás ventanas del editor.',
  notOffline:
    'El editor aún no funciona sin conexión: la descarga se ha interrumpido. Continuará en el próximo inicio.',
  offered: (files) => `Un enlace u otro programa quiere abrir ${fewNames(files)}.`,
  shareFailed: 'No se ha podido recibir la imagen compartida. Abra aquí su archivo.',
  notGiven: (file) => `No se ha podido leer ${file}: se ha movido o cambiado. Ábralo aquí.`,
};

/** The words of buttons in notices. */
export const answers: Texts['answers'] = {
  tryAgain: 'Reintentar',
  continueDrawing: 'Seguir dibujando',
  takeBack: 'Quitar trazos',
  exportAll: 'Exportar toda la imagen',
  holdBoundary: 'Fijar el contorno',
  extendSelection: 'Ampliar la selección',
  letFollow: 'Hacer que sigan',
  putBack: 'Recuperar',
  showOtherVersion: 'Mostrar la otra versión',
  keepThis: 'Conservar esta',
  backTo: (picture) => `Volver a ${picture}`,
  open: 'Abrir',
  openPicture: 'Abrir imagen',
  useRig: 'Usar este rig',
};
