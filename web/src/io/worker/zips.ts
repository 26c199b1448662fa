/** Worker: writes frames and sprite sheets as zip archives. */
import { serveFilms } from './serve_films';
import { FramesFilm, SheetFilm } from './zipped_film';

serveFilms(async ({ settings, encoder }, output) =>
  settings.format === 'sheet' ? SheetFilm.begin(settings, output, encoder) : new FramesFilm(settings, output),
);
