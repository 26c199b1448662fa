/** Shortens words that are too long to read, such as file names made by cameras and browsers. */

const MOST = 36;
const ENDING = 14;

/** The text with every word of more than `MOST` characters cut in its middle: its start and end identify it. */
export const shortened = (text: string): string =>
  text.replace(/\S+/gu, (word) => {
    const signs = [...word];
    if (signs.length <= MOST) return word;
    return [...signs.slice(0, MOST - ENDING - 1), '…', ...signs.slice(-ENDING)].join('');
  });
