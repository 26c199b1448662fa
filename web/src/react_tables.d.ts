/** Tables that the build makes from the manifest: see `web/scripts/manifest/react_tables.mjs`. */
declare module 'virtual:c2warp-react' {
  /** Properties that the component sets, with their values where it is given none. */
  export const PROPERTIES: Readonly<Record<string, unknown>>;
  /** Types of events by their listeners. */
  export const EVENTS: Readonly<Record<string, string>>;
}
