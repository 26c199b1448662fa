/** Evaluated in a page with the player's script by `npm run bench`: adds players, and waits until all play. */
async (count) => {
  await customElements.whenDefined('c2-warp-player');
  const players = Array.from({ length: count }, () => {
    const player = document.createElement('c2-warp-player');
    Object.assign(player, { src: '/sample.c2rig', autoplay: true, loop: true });
    player.style.width = '60px';
    return player;
  });
  const playing = players.map(
    (player) => new Promise((resolve) => player.addEventListener('timeupdate', resolve, { once: true })),
  );
  document.body.append(...players);
  await Promise.all(playing);
};
