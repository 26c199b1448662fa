import 'c2warp';
