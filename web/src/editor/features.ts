/** Parts of the editor that a page may leave out. */
export const FEATURES = ['tools', 'open', 'save', 'export', 'animate'] as const;
export type Feature = (typeof FEATURES)[number];

/** The features of an attribute, words between spaces; null, for all, without the attribute. */
export const featuresOf = (attribute: string | null): readonly Feature[] | null =>
  attribute === null ? null : FEATURES.filter((feature) => wordsOf(attribute).includes(feature));

/** The words of an attribute that do not name a feature. */
export const unknownFeatures = (attribute: string | null): readonly string[] =>
  wordsOf(attribute ?? '').filter((word) => !(FEATURES as readonly string[]).includes(word));

const wordsOf = (attribute: string): readonly string[] => attribute.split(/\s+/).filter(Boolean);

export const hasFeature = (features: readonly Feature[] | null, feature: Feature): boolean =>
  features === null || features.includes(feature);
