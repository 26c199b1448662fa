/** The rectangle of a drawing: the picture's own, that grown to all that is drawn, or all that is drawn alone. */
export type Area = 'picture' | 'grown' | 'covered';
