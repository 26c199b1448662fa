/** Worker: writes WebM and MP4 files by the encoders of the browser. */
import { serveFilms } from './serve_films';
import { VideoFilm } from './video_film';

serveFilms(({ settings }, output) =>
  VideoFilm.begin(settings, settings.format === 'mp4' ? 'mp4' : 'webm', output),
);
