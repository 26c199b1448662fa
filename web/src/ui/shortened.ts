/** Words that nobody reads to the end, such as the names that cameras and browsers give to files. */

const MOST = 36;
const ENDING = 14;

/** The text with every word beyond some length cut in its middle: how it begins and how it ends tell it from others. */
export const shortened = (text: string): string =>
  text.replace(/\S+/gu, (word) => {
    const signs = [...word];
    if (signs.length <= MOST) return word;
    return [...signs.slice(0, MOST - ENDING - 1), '…', ...signs.slice(-ENDING)].join('');
  });
