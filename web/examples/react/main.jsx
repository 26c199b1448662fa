import 'c2warp';
import { useState } from 'react';
import { createRoot } from 'react-dom/client';

function App() {
  const [selection, setSelection] = useState([]);
  return (
    <>
      <c2-warp
        src="/gingerbread.png"
        project="/gingerbread.c2warp.json"
        style={{ height: 600 }}
        onselectionchange={({ detail }) => setSelection(detail.selection)}
      />
      <p>Selected: {selection.join(', ') || 'nothing'}</p>
    </>
  );
}

createRoot(document.querySelector('#app')).render(<App />);
