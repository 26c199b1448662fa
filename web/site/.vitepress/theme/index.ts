import type { Theme } from 'vitepress';
import DefaultTheme from 'vitepress/theme-without-fonts';
import LiveFigure from './LiveFigure.vue';
import SchemaTables from './SchemaTables.vue';
import WarpPicture from './WarpPicture.vue';
import WarpPlayground from './WarpPlayground.vue';
import './code.css';
import './site.css';

export default {
  extends: DefaultTheme,
  enhanceApp({ app }) {
    app.component('LiveFigure', LiveFigure);
    app.component('SchemaTables', SchemaTables);
    app.component('WarpPicture', WarpPicture);
    app.component('WarpPlayground', WarpPlayground);
  },
} satisfies Theme;
