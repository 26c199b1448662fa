/** Errors with sentences of the whole table. */
import { errorsIn } from '../error';
import { en } from '../texts/en';

export const editorError = errorsIn<'errors'>(en);
