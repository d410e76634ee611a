// Orthanc with a temporary storage, and OHIF on top of it: static files of the npm package, and a proxy to Orthanc's DICOMweb.
import { spawn, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { createReadStream, existsSync, mkdirSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { Server } from 'node:net';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath, format } from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));
const PACKAGE = '@ohif/app@3.12.10';
const INTEGRITY = 'sha512-0kuF66Mq9c9dMD++bUsTjMrJpXJwaZhz9B4uS244DawAjSkTwIYFU93pxPuRUQixaRi7QAHlF3Fe1qudBlZrmA==';
const DICOM_WEB = '/usr/share/orthanc/plugins/libOrthancDicomWeb.so';
const TYPES = {
  '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml', '.png': 'image/png', '.ico': 'image/x-icon', '.woff2': 'font/woff2',
};
const OK = 200; // HTTP status
const START_TIME = 30000; // milliseconds for Orthanc's first answer
const DOWNLOAD_TIME = 300000; // milliseconds; 48 MB

const run = (program, ...options) => spawnSync(program, options, { encoding: 'utf8', timeout: DOWNLOAD_TIME });

// Downloads OHIF to the folder, if it is not there yet. Returns the reason why this is impossible, or nothing.
function download(folder) {
  if (existsSync(join(folder, 'ohif'))) return '';
  const unpacked = join(folder, 'unpacked');
  rmSync(unpacked, { recursive: true, force: true });
  mkdirSync(unpacked, { recursive: true });
  const packed = run('npm', 'pack', '--loglevel=error', '--fetch-retries=0', '--pack-destination', folder, PACKAGE);
  if (packed.error) return `npm cannot be run: ${packed.error.message}`;
  if (packed.status !== 0) return `npm cannot get ${PACKAGE}: ${packed.stderr.trim().split('\n').slice(0, 2).join('; ')}`;
  const archive = join(folder, packed.stdout.trim());
  const found = `sha512-${createHash('sha512').update(readFileSync(archive)).digest('base64')}`;
  if (found !== INTEGRITY) throw new Error(`${archive} is not the expected ${PACKAGE}: ${found}`);
  const { status, stderr } = run('tar', 'xzf', archive, '-C', unpacked);
  if (status !== 0) throw new Error(stderr);
  renameSync(join(unpacked, 'package/dist'), join(folder, 'ohif'));
  rmSync(unpacked, { recursive: true });
  rmSync(archive);
  return '';
}

// Returns the reason why the test cannot run, or nothing.
export function missing(folder) {
  if (run('Orthanc', '--version').error || !existsSync(DICOM_WEB)) {
    return 'orthanc and orthanc-dicomweb are not installed; see Utilities/install-dependencies workflow-tests';
  }
  return download(folder);
}

const LOOPBACK = '127.0.0.1';
const wait = (ms) => new Promise((done) => { setTimeout(done, ms); });

// Sends a request to a local port; returns the status of the answer, or 0 if there is none.
const ask = (port, method, path, body = '') => new Promise((done) => {
  const asked = request({ host: LOOPBACK, port, method, path }, (answer) => answer.resume().on('end', () => done(answer.statusCode)));
  asked.on('error', () => done(0));
  asked.end(body);
});

// Returns the bytes of an answer.
const get = (port, path) => new Promise((done, fail) => {
  const asked = request({ host: LOOPBACK, port, path }, (answer) => {
    const parts = [];
    answer.on('data', (part) => parts.push(part)).on('end', () => done(Buffer.concat(parts)));
  });
  asked.on('error', fail).end();
});

const freePort = () => new Promise((done) => {
  const socket = new Server().listen(0, LOOPBACK, () => {
    const { port } = socket.address();
    socket.close(() => done(port));
  });
});

async function startOrthanc(folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort();
  writeFileSync(join(folder, 'orthanc.json'), JSON.stringify({
    Name: 'test', StorageDirectory: join(folder, 'storage'), HttpPort: port, RemoteAccessAllowed: false, DicomServerEnabled: false,
    AuthenticationEnabled: false, Plugins: [DICOM_WEB], DicomWeb: { Enable: true, Root: '/dicom-web/' },
  }));
  // Orthanc ends with the test, even if that is killed.
  const child = spawn('setpriv', ['--pdeathsig', 'TERM', 'Orthanc', join(folder, 'orthanc.json')], { stdio: 'ignore' });
  for (const end = Date.now() + START_TIME; await ask(port, 'GET', '/system') !== OK;) {
    if (Date.now() > end || child.exitCode !== null) throw new Error('Orthanc does not start');
    await wait(100);
  }
  return { child, port };
}

function sendFile(root, path, response) {
  const wanted = join(root, normalize(path));
  const file = wanted.startsWith(root) && existsSync(wanted) && statSync(wanted).isFile() ? wanted : join(root, 'index.html');
  response.writeHead(OK, { 'Content-Type': TYPES[extname(file)] || 'application/octet-stream' });
  createReadStream(file).pipe(response);
}

function forward(port, asked, response) {
  const { method, url, headers } = asked;
  const onward = request({ host: LOOPBACK, port, method, path: url, headers }, (answer) => {
    response.writeHead(answer.statusCode, answer.headers);
    answer.pipe(response);
  });
  onward.on('error', () => response.destroy());
  asked.pipe(onward);
}

// Serves OHIF of the package folder. Returns its URL, and functions that store, list and return files and end everything.
export async function serve(packageFolder, workFolder) {
  const orthanc = await startOrthanc(workFolder);
  const root = join(packageFolder, 'ohif');
  const server = createServer((asked, response) => {
    const pathname = asked.url.split('?')[0];
    if (pathname.startsWith('/dicom-web/')) forward(orthanc.port, asked, response);
    else if (pathname === '/app-config.js') sendFile(HERE, pathname, response);
    else sendFile(root, pathname, response);
  });
  await new Promise((done) => { server.listen(0, LOOPBACK, done); });
  return {
    url: format({ protocol: 'http', hostname: LOOPBACK, port: server.address().port }),
    async store(file) {
      const status = await ask(orthanc.port, 'POST', '/instances', readFileSync(file));
      if (status !== OK) throw new Error(`Orthanc does not store ${file}: status ${status}`);
    },
    // UIDs of the stored studies.
    async studies() {
      const all = JSON.parse(await get(orthanc.port, '/studies?expand'));
      return all.map(({ MainDicomTags }) => MainDicomTags.StudyInstanceUID);
    },
    // Orthanc's identifiers of all files.
    async files() { return JSON.parse(await get(orthanc.port, '/instances')); },
    fileOf: (identifier) => get(orthanc.port, `/instances/${identifier}/file`),
    async close() {
      server.closeAllConnections();
      server.close();
      const gone = new Promise((done) => { orthanc.child.on('exit', done); });
      orthanc.child.kill();
      await gone;
      rmSync(workFolder, { recursive: true, force: true });
    },
  };
}
