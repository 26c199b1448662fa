/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { countedHandles, fewNames, number, plural, quoted } from './language';

const GRAPHICS_LOST = 'La tarjeta gráfica ya no responde, así que no se puede mostrar la imagen.';

const inRows = (rows: boolean): string =>
  rows ? ' en filas regulares, pues no hay un contorno que seguir' : '';

export const notices: Texts['notices'] = {
  nothingToHold: 'Aquí no hay nada que sujetar: hay que colocar el punto de control sobre la imagen.',
  lassoOutside: 'Fuera de la selección, la imagen se queda quieta.',
  lassoEmpty: 'El lazo está vacío: debe rodear una parte de la imagen.',
  lassoFilled: 'Ahora solo se deforma esta parte, sobre un fondo relleno.',
  lassoLoose: 'Ahora solo se deforma esta parte. Deja un hueco donde se aleja.',
  partOnFrame: 'La parte toca el borde de la imagen, que está sujeto: no puede girar.',
  leftOut: (count) =>
    plural(count, {
      one: 'Se ha quitado un punto de control fuera del lazo. Deshacer lo recupera.',
      other: `Se han quitado ${count} puntos de control fuera del lazo. Deshacer los recupera.`,
    }),
  notKept:
    'El trabajo no se conserva en este navegador: su almacenamiento está lleno o bloqueado. Conviene guardar el proyecto antes de salir.',
  otherTab:
    'Otra pestaña también ha cambiado este trabajo. Se conservan las dos versiones: al recargar se ofrecen.',
  twoVersions: (picture) => `${picture} se ha cambiado en dos pestañas. Esta es la versión más reciente.`,
  graphicsLost: `${GRAPHICS_LOST} Hay que recargar la página.`,
  graphicsLostStored: `${GRAPHICS_LOST} No se ha perdido nada: basta con recargar la página.`,
  graphicsLostUnstored: `${GRAPHICS_LOST} Aún no se ha perdido nada: hay que guardar el proyecto y después recargar la página.`,
  clipNameTaken: (name) => `Otro clip se llama ${quoted(name)}. Se mantiene el nombre anterior.`,

  outsidePicture: (handles) =>
    plural(handles.length, {
      one: `Una parte de ${handles[0]} queda fuera de la imagen y no mueve nada.`,
      other: `Partes de ${fewNames(handles)} quedan fuera de la imagen y no mueven nada.`,
    }),
  outsideLasso: (handles) =>
    plural(handles.length, {
      one: `Una parte de ${handles[0]} queda fuera del lazo y no mueve nada.`,
      other: `Partes de ${fewNames(handles)} quedan fuera del lazo y no mueven nada.`,
    }),
  nameStays: {
    empty: (name) => `Un punto de control necesita un nombre: se mantiene ${quoted(name)}.`,
    taken: (name) => `Otro punto de control tiene este nombre: se mantiene ${quoted(name)}.`,
  },
  outlineSimplified: 'Este contorno es muy fino, así que se sigue con menos exactitud.',
  outlineBridged: (pixels) =>
    `Este contorno es demasiado fino para seguirlo: las partes separadas hasta ${pixels} píxeles se deforman juntas.`,
  outlinePicture: 'Este contorno es demasiado fino para seguirlo: se deforma toda la imagen.',
  looseParts: (count) =>
    plural(count, {
      one: 'Una parte no tiene punto de control y se queda atrás.',
      other: `${count} partes no tienen punto de control y se quedan atrás.`,
    }),
  sameThere: 'Los dos lados ya son iguales.',
  noOtherSide: (handles) => `La imagen no tiene nada al otro lado de ${fewNames(handles)}.`,
  noCounterpart: (handles) =>
    plural(handles.length, {
      one: `Ningún punto de control corresponde aquí a la pose de ${handles[0]}.`,
      other: `Ningún punto de control corresponde aquí a las poses de ${fewNames(handles)}.`,
    }),
  brushedStill: 'Los puntos de control están en reposo. Los trazos del pincel se mantienen.',

  noPose: 'No hay ninguna pose en el portapapeles: primero hay que copiar una.',
  badPose: (detail) => `Esta pose no se puede pegar: ${detail}.`,
  notCopied: 'El navegador ha bloqueado el portapapeles: la pose solo se puede pegar en esta página.',
  notCopiedByMenu: (keys) =>
    `El navegador ha bloqueado el portapapeles: la pose solo se puede pegar en esta página. ${keys} la copia para otras páginas.`,
  notRead: 'El navegador ha bloqueado el portapapeles: hay que permitirlo para pegar.',
  notReadByMenu: (keys) => `El navegador ha bloqueado el portapapeles: pulsar ${keys} para pegar.`,

  emptyAddress: 'No hay ninguna dirección: escribir una que empiece por https://',
  noAddress: (text) =>
    `${quoted(text)} no es la dirección de una imagen: debe empezar por https:// o data:image/.`,
  nothingDropped: 'Lo que se ha soltado no contiene ninguna imagen ni la dirección de una.',
  notCarried: (picture, why) => `${picture} se ha abierto solo como imagen. ${why}`,
  removed: (picture) => `${picture} ya no está en la lista.`,
  removedAll: (count) =>
    plural(count, {
      one: 'Se ha quitado 1 imagen de la lista.',
      other: `Se han quitado ${count} imágenes de la lista.`,
    }),
  notOpened: (file, more) =>
    `Solo se abre una imagen a la vez. Sin abrir: ${more === 0 ? file : `${file} y ${more} más`}.`,
  moves: (picture) => `${picture} tiene movimiento. Solo está abierto su primer fotograma.`,
  lacksTexts: (picture) =>
    `${picture} tarda mucho en dibujarse, así que se abre sin sus textos. Para verlos, hay que convertirlos en trazados.`,
  isOpen: (picture) => `Imagen abierta: ${picture}.`,
  saved: (file) => `Guardado como ${file}.`,
  savedCut: (file) => `Guardado como ${file}. La parte fuera del marco está cortada.`,
  selectOne: 'Esto se refiere a un punto de control: primero hay que seleccionarlo.',

  awaiting: (project, source, width, height) =>
    `${project} pertenece a la imagen ${source || 'para la que se hizo'} (${width} × ${height} px). Hay que abrir esa imagen para continuar.`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${project} pertenece a la imagen ${source || 'para la que se hizo'} (${width} × ${height} px). Hay que abrir esa imagen para continuar, o usar su rig en ${picture}.`,
  theProject: 'El proyecto',
  movedInside: (handles) =>
    plural(handles.length, {
      one: `${handles[0]} quedaba al lado de esta imagen y ahora está sobre ella.`,
      other: `${fewNames(handles)} quedaban al lado de esta imagen y ahora están sobre ella.`,
    }),

  folds: 'La imagen se pliega.',
  foldedBy: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} pliega la imagen.`,
      other: `${fewNames(handles, quoted)} pliegan la imagen entre sí.`,
    }),
  leftFolds: (handles) =>
    plural(handles.length, {
      one: `${fewNames(handles, quoted)} ha vuelto a la pose más cercana sin pliegues.`,
      other: `${fewNames(handles, quoted)} han vuelto a la pose más cercana sin pliegues.`,
    }),
  noWayOut: 'No se ha encontrado ninguna pose sin pliegues entre esta y la de reposo.',

  placed: (added, rows) =>
    `${plural(added, { one: 'Se ha colocado', other: 'Se han colocado' })} ${countedHandles(added)}${inRows(rows)}. Al arrastrar uno se deforma la imagen.`,
  added: (added, there, rows) =>
    `${plural(added, { one: 'Se ha añadido', other: 'Se han añadido' })} ${countedHandles(added)}${inRows(rows)}. ${plural(
      there,
      {
        one: 'El que ya había se mantiene.',
        other: `Los ${number(there)} que ya había se mantienen.`,
      },
    )}`,
  noSuggestion: 'No se ha añadido ningún punto de control: ya hay uno cerca de cada lugar previsto.',
  noPlace: 'En esta imagen no cabe ningún punto de control.',

  noKeysSelected: 'No hay claves seleccionadas.',
  noCopiedKeys: 'No se ha copiado ninguna clave.',
  copiedKeys: (count) => plural(count, { one: '1 clave copiada', other: `${number(count)} claves copiadas` }),
  keysLeftOut: (count) =>
    plural(count, {
      one: 'Se ha omitido 1 clave: está más allá del final del clip o es de un punto de control que no está aquí.',
      other: `Se han omitido ${count} claves: están más allá del final del clip o son de un punto de control que no está aquí.`,
    }),

  newVersion: 'Hay una versión nueva lista. Se abre en el próximo inicio.',
  newVersionWaits: 'Hay una versión nueva lista. Se abre cuando se cierren las demás ventanas del editor.',
  notOffline:
    'El editor no está guardado para usarlo sin red: la descarga se ha interrumpido. El próximo inicio lo vuelve a intentar.',
  shareFailed: 'La imagen compartida no ha llegado. Se puede abrir aquí su archivo.',
  notGiven: (file) => `No se puede leer ${file}: se ha movido o cambiado. Se puede abrir aquí.`,
};

/** The words of buttons in notices. */
export const answers: Texts['answers'] = {
  tryAgain: 'Reintentar',
  takeBack: 'Deshacer',
  exportAll: 'Exportar todo',
  holdBoundary: 'Sujetar el contorno',
  extendSelection: 'Ampliar la selección',
  letFollow: 'Hacer que sigan',
  putBack: 'Recuperar',
  showOtherVersion: 'Mostrar la otra versión',
  keepThis: 'Conservar esta',
  backTo: (picture) => `Volver a ${picture}`,
  openPicture: 'Abrir imagen',
  useRig: 'Usar este rig',
};
