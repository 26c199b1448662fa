/** A corner of a bar or polygon, counted from 0. */
export interface Corner {
  readonly id: string;
  readonly index: number;
}
