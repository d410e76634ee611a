// Every page that the tools write opens from file:// without errors and without a network, in the style that all share.
// usage: FOLDERS=folder|folder... node --test pages.test.mjs
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';

let page;
before(async () => { page = await launch({ width: 1280, height: 800 }); });
after(() => page.close());

const pagesIn = (folder) => readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
  const path = join(folder, entry.name);
  return entry.isDirectory() ? pagesIn(path) : entry.name.endsWith('.html') ? [path] : [];
});

for (const folder of process.env.FOLDERS.split('|')) {
  test(`pages in ${folder}`, async () => {
    const files = pagesIn(folder);
    assert.ok(files.length > 0, 'there are none');
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
