/** Errors of files that are written. */
import { errorsIn } from '../error';
import { writingErrors } from '../texts/en/writing_errors';

export const writingError = errorsIn<'errors.writing'>({ errors: { writing: writingErrors } });
