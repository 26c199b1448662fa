/** The red, green and blue of a colour such as `#ffcc00`. */
export const colourOf = (colour: string): readonly [number, number, number] => {
  const at = (start: number) => Number.parseInt(colour.slice(start, start + 2), 16);
  return [at(1), at(3), at(5)];
};
