/** Errors of files that are written: exports of pictures and films. */
export const writingErrors = {
  /** @param format such as PNG. @param why one of `reasons`. */
  picture: (format: string, why: string) => `Could not write the ${format}: ${why}`,
  film: (why: string) => `Could not encode the film: ${why}`,
  filmStorage: (why: string) => `Could not save the film: ${why}`,
  /** They follow a colon. */
  reasons: {
    encoderFailed: 'the encoder failed or did not load. Reload the page.',
    encoderStopped: 'the encoder stopped or did not load. Reload the page.',
    encoderNotLoaded: (address: string) =>
      `the encoder did not load. Check that ${address} exists, and check your connection.`,
    canvasTooLarge: 'this browser cannot draw a picture of this size. Choose a smaller size, or PNG.',
    formatUnsupported: 'this browser cannot write this format. Choose PNG.',
    noCodec: 'this browser cannot encode this format at this size. Choose another format.',
    codecFailed: 'the browser’s encoder failed. Choose a smaller size, or another format.',
    filmTooLarge: 'it is too large for memory in this browser. Choose a smaller size, or another format.',
    zipTooLarge: 'a zip holds at most 4 GB. Choose a smaller size, or fewer frames.',
    diskFull: 'the disk is full.',
    diskRefuses:
      'the disk rejected the file. Check that the disk is connected and that this page may write to it.',
    /** @param detail a message of the encoder, in English. */
    other: (detail: string) => `${detail}.`,
  },
};
