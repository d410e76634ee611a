// Validates FHIR bundles with the npm package fhir, which is downloaded to a folder; its versions are pinned by package-lock.json.
// usage: PACKAGE=folder for the package BUNDLES=file,... node --test bundle.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const { PACKAGE, BUNDLES } = process.env;
const HERE = dirname(fileURLToPath(import.meta.url));
const DOWNLOAD_TIME = 120000; // milliseconds

// Downloads the package, if it is not there yet. Returns the reason why this is impossible, or nothing.
function missing() {
  mkdirSync(PACKAGE, { recursive: true });
  for (const name of ['package.json', 'package-lock.json']) copyFileSync(join(HERE, name), join(PACKAGE, name));
  if (existsSync(join(PACKAGE, 'node_modules/.package-lock.json'))) return '';
  const options = ['--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error', '--fetch-retries=0'];
  const installed = spawnSync('npm', ['ci', ...options], { cwd: PACKAGE, encoding: 'utf8', timeout: DOWNLOAD_TIME });
  if (installed.error) return `npm cannot be run: ${installed.error.message}`;
  if (/EINTEGRITY/.test(installed.stderr)) throw new Error(installed.stderr);
  return installed.status === 0 ? '' : `npm cannot get fhir: ${installed.stderr.trim().split('\n').slice(0, 2).join('; ')}`;
}

const reason = missing();
if (reason) console.log(`skipped: ${reason}`);
else {
  const { Fhir } = createRequire(join(PACKAGE, 'package.json'))('fhir');
  const fhir = new Fhir();
  const problems = (bundle) => fhir.validate(bundle, { errorOnUnexpected: true }).messages
    .filter(({ severity }) => severity === 'error' || severity === 'fatal');
  for (const path of BUNDLES.split(',')) {
    const text = readFileSync(path, 'utf8');
    const find = (bundle, type) => bundle.entry.find(({ resource }) => resource.resourceType === type).resource;
    test(`${path} is valid`, () => assert.deepEqual(problems(JSON.parse(text)), []));
    test(`${path} has a valid form in XML`, () => assert.deepEqual(problems(fhir.jsonToXml(text)), []));
    const faults = {
      'a wrong status': (bundle) => { find(bundle, 'DiagnosticReport').status = 'unknown word'; },
      'a missing code': (bundle) => { delete find(bundle, 'Observation').code; },
      'an unknown member': (bundle) => { find(bundle, 'ImagingStudy').slices = 1; },
      'a number that is a text': (bundle) => { find(bundle, 'ImagingStudy').numberOfSeries = 'six'; },
    };
    for (const [what, spoil] of Object.entries(faults)) {
      test(`${path} with ${what} is invalid`, () => {
        const bundle = JSON.parse(text);
        spoil(bundle);
        assert.notEqual(problems(bundle).length, 0);
      });
    }
  }
}
