'use client';
import 'c2warp';

export default function Page() {
  return <c2-warp src="/gingerbread.png" project="/gingerbread.c2warp.json" style={{ height: 600 }} />;
}
