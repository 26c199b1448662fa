/** The errors of requests to the worker. */
import { C2WarpError } from '../error';
import type { Failure } from './messages';

/** The error of a request that the worker refuses. */
export const failureError = ({ code, message, handles = [], wording }: Failure): C2WarpError =>
  new C2WarpError(code, message, { handles, wording });

/** The error of a request that a newer one has made pointless. */
export const superseded = (): DOMException => new DOMException('superseded', 'AbortError');
