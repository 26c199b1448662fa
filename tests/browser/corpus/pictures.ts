/** Encoded parts that are too intricate to write here. */
import { type Bytes, latin } from './bytes';

const decoded = (base64: string): Bytes => [...Buffer.from(base64, 'base64')];

/** The chunk of a lossy WebP: the flag of `FLAG` with 8 × 8 pixels a field. */
export const LOSSY = decoded(
  'VlA4IEQAAACQAgCdASoYABAABABoJaACdMoRwNsA/GbkAAbmAAD+kzpr/S3//eVhfQaiUiy7/6Eeu/nV9Zf//1C/uB43N5y3' +
    '0uU0AA==',
);

/** An AVIF of 2 × 2 pixels. */
export const AVIF = decoded(
  'AAAAIGZ0eXBhdmlmAAAAAGF2aWZtaWYxbWlhZk1BMUIAAADybWV0YQAAAAAAAAAoaGRscgAAAAAAAAAAcGljdAAAAAAAAAAAAAAA' +
    'AGxpYmF2aWYAAAAADnBpdG0AAAAAAAEAAAAeaWxvYwAAAABEAAABAAEAAAABAAABGgAAAB0AAAAoaWluZgAAAAAAAQAAABppbmZl' +
    'AgAAAAABAABhdjAxQ29sb3IAAAAAamlwcnAAAABLaXBjbwAAABRpc3BlAAAAAAAAAAIAAAACAAAAEHBpeGkAAAAAAwgICAAAAAxh' +
    'djFDgQ0MAAAAABNjb2xybmNseAACAAIAAYAAAAAXaXBtYQAAAAAAAAABAAEEAQKDBAAAACVtZGF0EgAKCBgANogQEAwgMg8f8D//' +
    '/8WfhwB8+ErK42A=',
);

/** A BMP of 3 × 2 red pixels, 24 bits each. */
export const BMP: Bytes = [
  ...latin('BM'),
  ...[78, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0],
  ...[40, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0, 1, 0, 24, 0, 0, 0, 0, 0, 24, 0, 0, 0],
  ...new Array<number>(16).fill(0),
  ...[0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0],
  ...[0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0],
];
