// Checks that every page of the tools opens from file:// without errors, without network requests, and in the shared style.
// usage: PAGES=FOLDER|FILE.html|... node --test pages.test.mjs
import assert from 'node:assert/strict';
import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';

let page;
before(async () => { page = await launch({ width: 1280, height: 800 }); });
after(() => page.close());

const pagesIn = (path) => {
  if (statSync(path).isDirectory()) return readdirSync(path).flatMap((name) => pagesIn(join(path, name)));
  return path.endsWith('.html') ? [path] : [];
};

for (const path of process.env.PAGES.split('|')) {
  test(`pages in ${path}`, async () => {
    const files = pagesIn(path);
    assert.ok(files.length > 0, 'no pages found');
    for (const file of files) {
      page.errors.length = page.requests.length = 0;
      await page.open(file);
      await page.until(() => !globalThis.startColonViewer || Boolean(globalThis.viewer) || document.body.classList.contains('failed'));
      assert.deepEqual(page.errors, [], file);
      assert.deepEqual(page.requests.filter((r) => !/^(file|blob|data):/.test(r)), [], file);
      const { title, style, blank, text } = await page.evaluate(() => ({
        title: document.title, style: document.querySelector('style').textContent, text: document.body.innerText.length,
        blank: [...document.images].filter((image) => !image.naturalWidth).length,
      }));
      assert.ok(title && style.includes('--paper') && !blank && text > 50, file);
      assert.equal(await page.evaluate(() => document.body.classList.contains('failed')), false, file);
    }
  });
}
