/** Evaluated in a page by `npm run bench`: waits for frames. */
async (count) => {
  for (let frame = 0; frame < count; frame++) await new Promise(requestAnimationFrame);
};
