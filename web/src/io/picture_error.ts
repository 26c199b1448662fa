/** A file that cannot be opened as a picture. The message can be shown: it says what is wrong, and the limit. */
export class PictureError extends Error {
  readonly code = 'picture';

  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'PictureError';
  }
}
