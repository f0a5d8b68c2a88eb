/** Puts the Python server, its pure-Python dependencies, and a runtime for machines without Python under `bundled/`. */
import { execFileSync } from 'node:child_process';
import { cpSync, readdirSync, rmSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
const libs = path.join(here, 'bundled', 'libs');
const python = process.env.PYTHON ?? 'python3';

rmSync(libs, { recursive: true, force: true });
execFileSync(
  python,
  ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', '--no-compile', '--only-binary', ':all:', '--no-binary', 'deburr', '--target', libs, path.dirname(here)],
  { stdio: ['ignore', 'inherit', 'inherit'], env: { ...process.env, PYTHONDONTWRITEBYTECODE: '1' } },
);
rmSync(path.join(libs, 'bin'), { recursive: true, force: true });
const compiled = readdirSync(libs, { recursive: true }).filter((name) => /\.(so|pyd|dylib)$/.test(String(name)));
if (compiled.length > 0) throw new Error(`the bundle must be pure Python, but holds ${compiled.join(', ')}`);
const runtime = path.join(here, 'node_modules', 'pyodide');
for (const name of ['pyodide.mjs', 'pyodide.asm.mjs', 'pyodide.asm.wasm', 'pyodide-lock.json', 'python_stdlib.zip']) {
  cpSync(path.join(runtime, name), path.join(here, 'bundled', 'pyodide', name));
}
cpSync(path.join(path.dirname(here), 'LICENSE'), path.join(here, 'LICENSE'), { force: true });
