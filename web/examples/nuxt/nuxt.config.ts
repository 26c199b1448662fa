export default defineNuxtConfig({
  vue: { compilerOptions: { isCustomElement: (tag) => tag === 'c2-warp' } },
});
