/** Errors of pictures, addresses and carried projects. A worker loads the English texts of only these. */
import { errorsIn } from '../error';
import { addressErrors, carriedErrors, pictureErrors } from '../texts/en/picture_errors';

export const pictureError = errorsIn<'errors.picture'>({ errors: { picture: pictureErrors } });
export const addressError = errorsIn<'errors.address'>({ errors: { address: addressErrors } });
export const carriedError = errorsIn<'errors.carried'>({ errors: { carried: carriedErrors } });
