/** Errors of files that are written: exports of pictures and films. */
export const writingErrors = {
  /** @param format such as PNG. @param why one of `reasons`. */
  picture: (format: string, why: string) => `The ${format} could not be written: ${why}`,
  film: (why: string) => `The film could not be encoded: ${why}`,
  filmStorage: (why: string) => `The film could not be saved: ${why}`,
  /** They follow a colon. */
  reasons: {
    encoderFailed: 'the encoder failed or did not load. Reload the page.',
    encoderStopped: 'the encoder stopped or did not load. Reload the page.',
    encoderNotLoaded: (address: string) =>
      `its encoder could not be loaded: is ${address} there, and the network?`,
    canvasTooLarge: 'this browser has no canvas of this size. Choose a smaller scale, or PNG.',
    formatUnsupported: 'this browser cannot write this format. Choose PNG.',
    noCodec: 'this browser does not encode this format at this size. Choose another format.',
    codecFailed: 'the browser’s encoder failed. Choose a smaller size, or another format.',
    filmTooLarge: 'it needs more memory than this browser gives. Choose a smaller size, or another format.',
    zipTooLarge: 'a zip holds at most 4 GB. Choose a smaller size, or fewer frames.',
    diskFull: 'the disk is full.',
    diskRefuses: 'the disk does not take it. Is it still there, and may this page write to it?',
    /** @param detail a message of the encoder, in English. */
    other: (detail: string) => `${detail}.`,
  },
};
