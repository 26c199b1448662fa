/** A file that cannot be opened as a picture. The message is fit to be shown: what is wrong, and the limit. */
export class PictureError extends Error {
  readonly code = 'picture';

  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'PictureError';
  }
}
