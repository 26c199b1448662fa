/** A file cannot be opened as a picture. The message is for the user: it names the problem and the limit. */
export class PictureError extends Error {
  readonly code = 'picture';

  constructor(message: string, options?: ErrorOptions) {
    super(message, options);
    this.name = 'PictureError';
  }
}
