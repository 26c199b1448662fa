/** The export panel. */
import type { Texts } from '../texts';
import { counted, list, number, plural } from './language';

export const exporting: Texts['exporting'] = {
  kind: 'Tipo',
  kinds: { picture: 'Imagen', film: 'Vídeo', page: 'Web', engine: 'Motor', maps: 'Mapas' },
  format: 'Formato',
  size: 'Tamaño',
  quality: 'Calidad',
  background: 'Fondo',
  area: 'Área',
  original: 'Original',
  allOfIt: 'Ampliada',
  covered: 'Recortada',
  export: (format) => `Exportar ${format}`,
  exportRig: 'Exportar rig',
  exportMap: 'Exportar mapa',
  exportWeights: 'Exportar pesos',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Sin pérdida, con transparencia.',
    jpeg: 'Archivos pequeños para fotografías, sin transparencia.',
    webp: 'Archivos pequeños, con transparencia.',
    svg: 'El dibujo con trazados deformados. Es nítido a cualquier tamaño.',
  },
  areaNotes: {
    picture: 'El marco de la imagen original.',
    grown: 'Ampliada para incluir las partes que salen del marco original.',
    covered: 'Recortada a la parte visible, sin borde vacío.',
  },
  remark: (detail) => `Observación: ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Un vídeo necesita un clip. Añada uno en la línea de tiempo.',
  openTimeline: 'Abrir la línea de tiempo',
  clip: 'Clip',
  frames: 'PNG sueltos',
  sheet: 'Hoja',
  formatNotes: {
    webm: 'Archivos pequeños con transparencia suave, para páginas web.',
    mp4: 'Archivos pequeños sin transparencia. Se reproduce casi en todas partes.',
    gif: 'Se reproduce en todas partes, pero solo tiene 255 colores y bordes duros.',
    apng: 'Sin pérdida, con transparencia suave.',
    webp: 'Sin pérdida y más pequeño que APNG.',
    frames: 'Un zip con un PNG por fotograma.',
    sheet:
      'Un zip con una hoja de sprites: todos los fotogramas en un PNG y un archivo JSON para motores de juego.',
  },
  codec: (name) => `Códec: ${name}.`,
  codecWithEvenSides: (name, width, height) =>
    `Códec: ${name}. El ancho y el alto se redondean a números pares: ${width} × ${height} px.`,
  gifRate: (most) =>
    `Los GIF tienen como máximo ${most} fotogramas por segundo, lo que reproducen los visores.`,
  noCodec: (formats) => `Este navegador no puede codificar ${list(formats)}.`,
  rate: 'Cadencia',
  rateTip: 'Fotogramas por segundo',
  allFrames: 'Ampliada',
  part: 'Tramo',
  wholeClip: 'Todo el clip',
  aPart: 'Un tramo',
  from: 'Desde',
  to: 'Hasta',
  transparent: 'Transparente',
  colour: 'Color',
  softEdgesOn: 'Color de mate',
  frameCount: (count) => counted(count, 'fotograma', 'fotogramas'),
  estimate: (size, time) => `aprox. ${size}, ${time}`,
  aFewSeconds: 'unos segundos',
  aFewSecondsLeft: 'quedan unos segundos',
  left: (time) => `quedan aprox. ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: 'Un archivo pequeño con todos los clips. Un script reproductor de 15 kB lo muestra sin el editor.',
  withoutClips: 'Sin clips, la página muestra la pose actual.',
  readers: 'Los visitantes pueden',
  watch: 'Ver clips',
  pose: 'Mover puntos',
  solver: 'Esto añade unos 100 kB al archivo y otros 100 kB a la página.',
  code: 'Código',
  copyCode: 'Copiar código',
  codeNote: 'Pegue esto en una página. Ponga junto a ella el archivo y la carpeta «player» del paquete.',
  codeCopied: (file) => `Copiado. Ponga ${file} y la carpeta «player» del paquete junto a la página.`,
  codeNotCopied: 'El navegador ha bloqueado el portapapeles. Copie usted mismo el código seleccionado.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Para Spine 4.2 y sus runtimes: JSON, atlas y PNG.',
    dragonbones: 'Para DragonBones 5.5 y sus runtimes: dos archivos JSON y un PNG.',
    gltf: 'glTF 2.0 para three.js, Blender y otros, en un archivo.',
    godot: 'Una escena de Godot 4 con su PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Contiene la malla, los huesos y la pose. Añada un clip para incluir una animación.'
      : plural(count, {
          one: 'Incluye el clip como animación.',
          other: `Incluye ${count} clips como animaciones.`,
        }),
  rough:
    'Los huesos solo se aproximan a los puntos de control, así que el rig se desvía un poco. La exportación indica cuánto.',
  bones: 'Huesos',
  bonesTip: 'Número máximo de huesos, sin contar la raíz',
  vertices: 'Vértices',
  verticesTip: 'Número máximo de vértices de la malla',
  influences: 'Huesos por vértice',
  files: 'Archivos',
  zip: 'Zip',
  folder: 'Carpeta',
  lossCaption: (bones, sites, vertices) =>
    `El último rig usa ${counted(bones, 'hueso', 'huesos')} para ${number(sites)} puntos de control y auxiliares, y ${counted(vertices, 'vértice', 'vértices')}. Error en píxeles:`,
  largest: 'Máxima',
  pose: 'Pose',
  randomPoses: 'Poses al azar',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Entre vértices',
  loss: (percentile, largest) =>
    `El 99 % de los vértices se desvía como mucho ${percentile} px. El mayor error es de ${largest} px.`,
};

export const maps: Texts['maps'] = {
  map: 'Mapa',
  names: {
    inverse: 'Inverso',
    forward: 'Directo',
    stretch: 'Estiramiento',
    disocclusion: 'Desoclusión',
    heat: 'Mapa de calor',
    weights: 'Pesos',
  },
  notes: {
    inverse: 'Un mapa ST para programas de composición. Aplica esta deformación a otras imágenes.',
    forward: 'Un mapa ST que deshace la deformación al aplicarlo a la imagen deformada.',
    stretch: 'Cuánto crecen áreas y longitudes en cada píxel de la imagen deformada.',
    disocclusion: 'Rojo donde la deformación descubre una zona, verde donde tapa una.',
    heat: 'Cuánto sigue la imagen a un punto de control, en colores sobre el original.',
    weights: 'Cuánto sigue cada punto del original a cada punto de control, en números para scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR con números de 32 bits en coma flotante. La cabecera describe los canales.',
    png: '16 bits por canal, para programas sin OpenEXR.',
  },
  csvNote: 'Una fila por cada peso mayor que 0.',
  npyNote: 'Una matriz de NumPy.',
  npyZipNote: 'Un zip con una matriz de NumPy y la lista de sus puntos de control y auxiliares.',
  of: 'Pesos de',
  allSites: 'Todos los puntos',
  selectedHandle: 'Punto seleccionado',
  every: 'Separación en píxeles',
  points: (width, height) => `${number(width)} × ${number(height)} puntos`,
  selected: (handle) => `Selección: ${handle}.`,
};
