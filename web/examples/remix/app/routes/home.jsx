import 'c2warp';

export default function Home() {
  return <c2-warp src="/gingerbread.png" project="/gingerbread.c2warp.json" style={{ height: 600 }} />;
}
