/** Errors of the solver's worker and module, with only their English texts. */
import { errorsIn } from '../error';
import { engineErrors, tooMuchErrors } from '../texts/en/solver_errors';

export const engineError = errorsIn<'errors.engine'>({ errors: { engine: engineErrors } });
export const tooMuchError = errorsIn<'errors.tooMuch'>({ errors: { tooMuch: tooMuchErrors } });
