/** Worker: writes GIF, animated PNG and animated WebP files by the module of the film encoders. */
import { ModuleFilm, type ModuleFormat } from './module_film';
import { opaqueOver } from './opaque_over';
import { serveFilms } from './serve_films';

serveFilms(({ settings, picture, encoder }, output) => {
  const { background, format } = settings;
  if (picture && background !== null) opaqueOver(background, picture);
  // The page asks this worker for no other format.
  return ModuleFilm.begin(settings, format as ModuleFormat, picture, encoder, (position, bytes) =>
    output.write(position, bytes),
  );
});
