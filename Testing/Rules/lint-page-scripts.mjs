// Lint of page scripts and their tests. usage: lint-page-scripts.mjs FOLDER... Prints each fault with file and line; status 1 if there
// are any. The modules of a folder `scripts` are joined with their imports into one script, so top-level names must be unique.
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';

const WIDTH = 140, LONGEST = 60; // characters of a line, lines of a function or method at the top level or in a class
const FORBIDDEN = [
  [/\b(fetch|XMLHttpRequest|WebSocket|EventSource|sendBeacon|importScripts)\b/, 'uses the network'],
  [/https?:\/\//, 'contains a network address'],
  [/\b(eval|Function)\s*\(/, 'evaluates text as code'],
  [/\b(var|debugger|alert)\b[^.,;:'’]/, 'is not allowed'],
  [/[^=!]==[^=]|!=[^=]/, 'compares without ==='],
  [/\s$/, 'ends with a blank'],
  [/\t/, 'contains a tab'],
  [/innerHTML(?! = [A-Z]+;)/, 'creates elements from nonconstant text'],
];
const faults = [];
const tell = (file, line, text) => faults.push(`${file}:${line}: ${text}`);

function scriptsIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((e) => {
    const path = join(folder, e.name);
    if (e.isDirectory()) return e.name === 'build' || e.name.startsWith('.') ? [] : scriptsIn(path);
    return e.name.endsWith('.mjs') ? [path] : [];
  });
}

// Removes comments and literals.
const codeOf = (line) => line.replace(/(['"])(?:\\.|(?!\1).)*\1/g, "''").replace(/(^|\s)\/\/.*/, '');

function checkLines(file, lines) {
  lines.forEach((line, i) => {
    if (line.length > WIDTH) tell(file, i + 1, `has ${line.length} characters, more than ${WIDTH}`);
    for (const [pattern, text] of FORBIDDEN) {
      const isOfText = text.startsWith('ends') || text.startsWith('holds') || text.startsWith('names');
      if (pattern.test(isOfText ? line : codeOf(line))) tell(file, i + 1, text);
    }
  });
}

// Blocks that start in column 0 or 2 and end with a brace in the same column.
function checkLengths(file, lines) {
  for (const [start, end] of [[/^(export )?(async )?function .*\{$/, '}'], [/^ {2}(async |get )?\w+\(.*\) \{$/, '  }']]) {
    lines.forEach((line, i) => {
      const length = start.test(line) ? lines.slice(i).indexOf(end) : 0;
      if (length > LONGEST) tell(file, i + 1, `is a function of ${length} lines, more than ${LONGEST}`);
    });
  }
}

function checkImports(file, text) {
  for (const [, names, from] of text.matchAll(/^import \{ ([^}]*) \} from '([^']*)'/gm)) {
    for (const name of names.split(', ')) {
      if (text.match(new RegExp(`\\b${name}\\b`, 'g')).length < 2) tell(file, 1, `imports ${name} and does not use it`);
    }
    if (!from.startsWith('.') && !from.startsWith('node:')) tell(file, 1, `imports the package ${from}`);
  }
}

function checkJoined(modules, all) {
  const owner = new Map();
  for (const { file, text } of modules) {
    for (const [, name] of text.matchAll(/^(?:export )?(?:async )?(?:const|let|function|class) (\w+)/gm)) {
      if (owner.has(name)) tell(file, 1, `has the top-level name ${name} of ${basename(owner.get(name))}`);
      owner.set(name, file);
      const exported = new RegExp(`^export (async )?(const|let|function|class) ${name}\\b`, 'm').test(text);
      const isUsed = all.some((m) => m.file !== file && new RegExp(`^import [^;]*\\b${name}\\b`, 'm').test(m.text));
      if (exported && !isUsed && !name.startsWith('start')) tell(file, 1, `exports ${name}, which no module imports`);
    }
  }
}

// Returns the modules of a folder and all their imports.
function joinedWith(folder) {
  const files = new Set(modules.map(({ file }) => file).filter((file) => dirname(file) === folder));
  for (const file of files) { // grows during the iteration
    const { text } = modules.find((m) => m.file === file);
    for (const [, from] of text.matchAll(/^import [^;]* from '(\.[^']*)'/gm)) files.add(join(dirname(file), from));
  }
  return modules.filter(({ file }) => files.has(file));
}

const modules = process.argv.slice(2).flatMap(scriptsIn).map((file) => ({ file, text: readFileSync(file, 'utf8') }));
for (const { file, text } of modules) {
  const lines = text.split('\n'), { status, stderr } = spawnSync(process.execPath, ['--check', file], { encoding: 'utf8' });
  if (status !== 0) tell(file, 1, stderr.trim().replace(/\n/g, ' '));
  if (basename(file) !== 'lint-page-scripts.mjs') checkLines(file, lines);
  checkLengths(file, lines);
  checkImports(file, text);
}
for (const folder of new Set(modules.map(({ file }) => dirname(file)))) {
  if (basename(folder) === 'scripts') checkJoined(joinedWith(folder), modules);
}
console.log(faults.length ? faults.join('\n') : `${modules.length} scripts are clean`);
process.exitCode = faults.length || modules.length === 0 ? 1 : 0;
