/**
 * The rectangle of a drawing: the picture's own, the picture's own enlarged to hold all that is drawn, or only the
 * drawn area.
 */
export type Area = 'picture' | 'grown' | 'covered';
