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
  allOfIt: 'Todo',
  covered: 'Cubierta',
  export: (format) => `Exportar ${format}`,
  exportRig: 'Exportar rig',
  exportMap: 'Exportar mapa',
  exportWeights: 'Exportar pesos',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: 'Cada píxel tal como es, con transparencia.',
    jpeg: 'Archivos pequeños para fotografías, sin transparencia.',
    webp: 'Archivos pequeños, con transparencia.',
    svg: 'El dibujo con trazados deformados, nítidos a cualquier tamaño.',
  },
  areaNotes: {
    picture: 'El rectángulo del original.',
    grown: 'Ampliada para contener las partes que salen del original.',
    covered: 'Solo la parte cubierta, sin borde vacío.',
  },
  remark: (detail) => `Observación: ${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'Aún no hay ningún clip: un vídeo muestra uno.',
  openTimeline: 'Abrir la línea de tiempo',
  clip: 'Clip',
  frames: 'PNG sueltos',
  sheet: 'Hoja',
  formatNotes: {
    webm: 'Pequeño, con transparencia suave. Para páginas web.',
    mp4: 'Pequeño, sin transparencia. Se reproduce casi en todas partes.',
    gif: 'Se reproduce en todas partes. 255 colores, bordes duros.',
    apng: 'Cada píxel tal como es, con transparencia suave.',
    webp: 'Cada píxel tal como es, más pequeño que un APNG.',
    frames: 'Un zip con un PNG por fotograma.',
    sheet: 'Un zip con todos los fotogramas en un PNG y un archivo JSON para motores de juego.',
  },
  codec: (name) => `Con ${name}.`,
  codecWithEvenSides: (name, width, height) => `Con ${name}. Sus lados son pares: ${width} × ${height} px.`,
  gifRate: (most) => `Un GIF recibe ${most} fotogramas por segundo, el máximo que reproducen los visores.`,
  noCodec: (formats) => `${list(formats)}: este navegador no lo codifica.`,
  rate: 'Cadencia',
  rateTip: 'Fotogramas por segundo',
  allFrames: 'Todos los fotogramas',
  part: 'Parte',
  wholeClip: 'Todo el clip',
  aPart: 'Una parte',
  from: 'Desde',
  to: 'Hasta',
  transparent: 'Transparente',
  colour: 'Color',
  softEdgesOn: 'Bordes suaves sobre',
  frameCount: (count) => counted(count, 'fotograma', 'fotogramas'),
  estimate: (size, time) => `aprox. ${size}, ${time}`,
  aFewSeconds: 'unos segundos',
  aFewSecondsLeft: 'quedan unos segundos',
  left: (time) => `quedan aprox. ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: 'Un archivo pequeño con todos los clips, para el reproductor: un script de 14 kB que no necesita editor.',
  withoutClips: 'Aún no hay ningún clip: la página muestra la pose.',
  readers: 'Lectores',
  watch: 'Ver clips',
  pose: 'Mover puntos',
  solver: 'La página carga entonces otros 100 kB, y el archivo crece más o menos lo mismo.',
  code: 'Código',
  copyCode: 'Copiar código',
  codeNote: 'Se pega en una página junto al archivo y a la carpeta “player” del paquete.',
  codeCopied: (file) =>
    `Copiado. El código muestra ${file} en una página situada junto a ese archivo y a la carpeta “player” del paquete.`,
  codeNotCopied:
    'El navegador ha bloqueado el portapapeles. El código está seleccionado: hay que copiarlo a mano.',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Spine 4.2 y sus runtimes: JSON, atlas y PNG.',
    dragonbones: 'DragonBones 5.5 y sus runtimes: dos archivos JSON y un PNG.',
    gltf: 'glTF 2.0 para three.js, Blender y otros: un archivo.',
    godot: 'Una escena de Godot 4 con su PNG.',
  },
  clips: (count) =>
    count === 0
      ? 'Malla, huesos y pose. Aún no hay ningún clip.'
      : plural(count, {
          one: 'Con el clip como animación.',
          other: `Con ${count} clips como animaciones.`,
        }),
  rough:
    'Los huesos se mezclan de forma más simple que los puntos de control, así que un rig se desvía un poco. La exportación indica cuánto.',
  bones: 'Huesos',
  bonesTip: 'Número máximo de huesos además de la raíz; cada punto de control tiene uno',
  vertices: 'Vértices',
  verticesTip: 'Número máximo de vértices de la malla',
  influences: 'Huesos por vértice',
  files: 'Archivos',
  zip: 'Zip',
  folder: 'Carpeta',
  lossCaption: (bones, sites, vertices) =>
    `El último rig tiene ${counted(bones, 'hueso', 'huesos')} para ${counted(sites, 'sitio', 'sitios')} y ${counted(vertices, 'vértice', 'vértices')}. Su desviación, en píxeles:`,
  largest: 'Máxima',
  pose: 'Pose',
  randomPoses: 'Poses al azar',
  clip: (name) => `Clip ${name}`,
  betweenVertices: 'Entre vértices',
  loss: (percentile, largest) =>
    `El 99 % de los vértices se desvía como mucho ${percentile} px; el peor, ${largest} px.`,
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
    inverse: 'Un mapa ST para programas de composición: deforma otras imágenes igual que esta.',
    forward: 'El camino de vuelta: como mapa ST sobre la imagen deformada, deshace la deformación.',
    stretch: 'Cuánto crecen áreas y longitudes en cada píxel de la imagen deformada.',
    disocclusion: 'Rojo donde la deformación descubre algo, verde donde tapa algo.',
    heat: 'Cuánto sigue la imagen a un punto de control, en colores sobre el original.',
    weights: 'Cuánto siguen los puntos del original, en números para scripts.',
  },
  formatNotes: {
    exr: 'OpenEXR con números de 32 bits en coma flotante. La cabecera explica los canales.',
    png: '16 bits por canal, para programas sin OpenEXR.',
  },
  csvNote: 'Una fila por cada peso mayor que 0.',
  npyNote: 'Una matriz para NumPy.',
  npyZipNote: 'Un zip: una matriz para NumPy y la lista de sus sitios.',
  of: 'De',
  allSites: 'Todos los sitios',
  selectedHandle: 'Punto seleccionado',
  every: 'Píxeles de punto a punto',
  points: (width, height) => `${number(width)} × ${number(height)} puntos`,
  selected: (handle) => `Selección: ${handle}.`,
};
