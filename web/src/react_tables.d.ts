/** Tables that the build generates from the manifest: see `web/scripts/manifest/react_tables.mjs`. */
declare module 'virtual:c2warp-react' {
  /** Properties that the component sets. */
  export const PROPERTIES: readonly string[];
  /** Types of events by their listeners. */
  export const EVENTS: Readonly<Record<string, string>>;
}
