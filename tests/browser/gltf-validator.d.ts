/** The validator of Khronos has no types of its own. */
declare module 'gltf-validator' {
  interface Report {
    issues: {
      numErrors: number;
      numWarnings: number;
      messages: { code: string; message: string; pointer: string }[];
    };
  }
  export function validateBytes(bytes: Uint8Array): Promise<Report>;
}
