/** The pages of the export panel beyond that of a picture. Loaded when one is first shown. */
import type { ExportPages } from '../export_pages';
import { filmPage } from './film';
import { filmStyle } from './film_style';

export const exportPages: ExportPages = { styles: [filmStyle], film: filmPage };
