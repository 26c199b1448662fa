import type {} from 'c2warp/types/vue';
