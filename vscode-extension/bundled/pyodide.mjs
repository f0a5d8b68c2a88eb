/**
 * The language server on a machine without Python: the same code under Pyodide, in the editor's own Node.
 * Standard input and output carry the protocol, as with a Python of the machine.
 */
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { loadPyodide } from './pyodide/pyodide.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const log = (line) => process.stderr.write(`${line}\n`);
const python = await loadPyodide({ indexURL: `${path.join(here, 'pyodide')}${path.sep}`, stdout: log, stderr: log });

python.FS.mkdirTree('/deburr');
python.mountNodeFS('/deburr', path.join(here, 'libs'));
python.globals.set('written', (bytes) => process.stdout.write(bytes));
python.globals.set('ended', (code) => process.exit(code));
const feed = python.runPython(`
import sys
sys.path.insert(0, "/deburr")
from pyodide.ffi import to_js
from deburr.lsp.embedded import Embedded

server = Embedded(lambda data: written(to_js(data)), ended)
lambda data: server.feed(data.to_bytes())
`);

/** Folders keep their paths, so that a URI means the same inside and outside. The first message names them. */
function mount(uri) {
  if (!uri?.startsWith('file:')) return;
  const inside = decodeURIComponent(new URL(uri).pathname);
  try {
    python.FS.mkdirTree(inside);
    python.mountNodeFS(inside, fileURLToPath(uri));
  } catch (error) {
    log(`the folder ${uri} cannot be read: ${error}`);
  }
}

function introduce(text) {
  const params = JSON.parse(text.slice(text.indexOf('{'))).params ?? {};
  const folders = params.workspaceFolders?.map((folder) => folder.uri) ?? [params.rootUri];
  folders.forEach(mount);
}

let first = true;
for await (const chunk of process.stdin) {
  // The editor writes `initialize` in one piece and waits for the answer before anything else.
  if (first) introduce(chunk.toString('utf8'));
  first = false;
  feed(new Uint8Array(chunk.buffer, chunk.byteOffset, chunk.byteLength));
}
process.exit(0);
