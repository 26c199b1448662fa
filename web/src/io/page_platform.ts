/** Decoding in the page, for browsers whose workers cannot. */
import type { Platform } from './decode';

export const pagePlatform: Platform = {
  createContext: () =>
    document.createElement('canvas').getContext('webgl2', { antialias: false, depth: false }),

  async imageOf(file) {
    const image = new Image();
    image.src = URL.createObjectURL(file);
    try {
      await image.decode();
      return image;
    } catch {
      return null;
    } finally {
      URL.revokeObjectURL(image.src);
    }
  },
};
