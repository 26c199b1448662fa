/** The pages of the export panel beyond that of a picture. Loaded when one is first shown. */
import type { ExportPages } from '../export_pages';
import { enginePage } from './engine';
import { engineStyle } from './engine_style';
import { filmPage } from './film';
import { filmStyle } from './film_style';
import { mapPage } from './map';
import { mapStyle } from './map_style';
import { webPage } from './web_page';
import { webPageStyle } from './web_page_style';

export const exportPages: ExportPages = {
  styles: [filmStyle, webPageStyle, engineStyle, mapStyle],
  film: filmPage,
  page: webPage,
  engine: enginePage,
  maps: mapPage,
};
