import type {} from 'c2warp/types/svelte';
