/** Compares what the TextMate grammars colour with what the texts in `test/colours` say. */
import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import path from 'node:path';

const texts = path.join('test', 'colours');
for (const text of readdirSync(texts)) {
  const grammar = path.join('syntaxes', `${path.parse(text).name}.tmLanguage.json`);
  execFileSync('npx', ['vscode-tmgrammar-test', '-g', grammar, path.join(texts, text)], { stdio: 'inherit', shell: process.platform === 'win32' });
}
