/** Makes the viewer of toolpaths that ships in the Python package: one script with three.js in it, the same bytes on every machine. */
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
const folder = path.join(here, 'viewer');
const out = process.argv[2] ?? path.join(here, '..', 'server', 'deburr', 'plot', 'viewer.js');

/** What the script is made from: its own sources, and the releases of what goes into it and makes it. */
const made = createHash('sha256');
for (const name of readdirSync(folder).sort()) made.update(`${name}\n`).update(readFileSync(path.join(folder, name)));
const { packages } = JSON.parse(readFileSync(path.join(here, 'package-lock.json'), 'utf8'));
for (const name of ['three', 'esbuild']) made.update(`${name} ${packages[`node_modules/${name}`].integrity}\n`);

const { outputFiles } = await build({
  entryPoints: [path.join(folder, 'main.ts')],
  absWorkingDir: here,
  bundle: true,
  write: false,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  loader: { '.css': 'text' },
  legalComments: 'none',
  tsconfigRaw: {},
});
const three = packages['node_modules/three'].version;
const head = `/* Made by vscode-extension/scripts/viewer.mjs from ${made.digest('hex')}. Holds three.js ${three}, copyright three.js authors, MIT licence. */\n`;
writeFileSync(out, head + outputFiles[0].text.replaceAll('</script', '<\\/script'));
