import vue from '@vitejs/plugin-vue';

const isCustomElement = (tag) => tag === 'c2-warp';

export default { plugins: [vue({ template: { compilerOptions: { isCustomElement } } })] };
