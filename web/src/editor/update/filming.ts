/** Exports of clips as films. */
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import type { ExportKind } from '../export_choices';
import {
  FILM_FORMATS,
  type FilmChoices,
  filmedClip,
  filmedRange,
  filmFormat,
  filmRate,
  isTransparent,
  videoBits,
} from '../film_choices';
import { filmSize } from '../film_model';
import { fileWord, stem } from '../picture';
import { type EditorState, filedProject } from '../state';
import { saveWork } from './autosave';
import { beginExport, withExport } from './export_slice';
import type { Handlers } from './handlers';
import { inform } from './notices';

/** Exports the chosen clip. Asks for the browser's codecs first, unless they are known. */
export function exportFilm(state: EditorState, emit: Emit): EditorState {
  const { picture, exporting } = state;
  const { film, codecs, running } = exporting;
  if (!picture || running) return state;
  const project = filedProject(state);
  const clip = filmedClip(project, film, state.timeline.clip);
  if (!clip) return inform(state, say('film.noClip'), emit);
  const format = filmFormat(film, codecs);
  if (!format) return findCodecs(withExport(state, { awaitsCodecs: true }), emit);
  const { extension, suffix } = FILM_FORMATS[format];
  const fileStem = `${stem(picture.name)}-${fileWord(clip.name)}${suffix}`;
  emit({
    type: 'export-film',
    name: `${fileStem}.${extension}`,
    project,
    clip,
    film: {
      format,
      bits: videoBits(film.quality),
      scale: film.percent / 100,
      area: film.area,
      rate: filmRate(format, film.rate),
      range: filmedRange(clip, film.range),
      background: isTransparent(format, film) ? null : film.background,
      matte: film.matte,
      name: fileStem,
    },
  });
  return beginExport(withExport(state, { awaitsCodecs: false }), emit);
}

function chooseKind(state: EditorState, kind: ExportKind, emit: Emit): EditorState {
  const next = withExport(state, { kind });
  return saveWork(kind === 'film' ? findCodecs(next, emit) : next, emit);
}

function chooseFilm(state: EditorState, choice: Partial<FilmChoices>, emit: Emit): EditorState {
  const { film } = state.exporting;
  // The part belongs to a clip.
  const range = choice.clip !== undefined && choice.clip !== film.clip ? { range: null } : {};
  const next = withExport(state, { film: { ...film, ...range, ...choice } });
  const isOfSize = 'percent' in choice || 'area' in choice || 'rate' in choice || 'clip' in choice;
  return saveWork(isOfSize ? findCodecs(next, emit) : next, emit);
}

/** The panel opens: it uses the clip of the timeline again. */
export function openExport(state: EditorState, emit: Emit): EditorState {
  const { kind, film } = state.exporting;
  const next = withExport(state, { film: { ...film, clip: null }, code: null });
  return kind === 'film' ? findCodecs(next, emit) : next;
}

/** Asks for the browser's codecs for films of the present size. */
export function findCodecs(state: EditorState, emit: Emit): EditorState {
  const size = filmSize(state);
  if (size) emit({ type: 'find-codecs', ...size, rate: state.exporting.film.rate });
  return state;
}

export const filmHandlers: Handlers<'export-kind-chosen' | 'film-choice-made' | 'codecs-found'> = {
  'export-kind-chosen': (state, { kind }, emit) => chooseKind(state, kind, emit),
  'film-choice-made': (state, { choice }, emit) => chooseFilm(state, choice, emit),
  'codecs-found': (state, { codecs }, emit) => {
    const next = withExport(state, { codecs });
    return state.exporting.awaitsCodecs ? exportFilm(next, emit) : next;
  },
};
